// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/section_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>
#include <utility>

// The curves before trimming are drawn in red, then the trimmed curves in blue and wider
// on top. Where trimming removed a part, the red curve remains visible.

namespace endmill {
namespace {

constexpr LineStyle before_style{"#d1402f", 1.2, ""};
constexpr LineStyle after_style{"#1d4f91", 2.2, ""};
constexpr LineStyle part_style{"#222222", 1.4, ""};
constexpr LineStyle cutter_style{"#8a6d1f", 1, "5 3"};
constexpr LineStyle curve_style{"#1d4f91", 0.8, ""};
constexpr LineStyle untrimmed_style{"#777777", 0.8, ""};
constexpr LineStyle exact_style{"#9ec5e8", 7, ""};
// Of different colour, lightness and pattern, so that they differ in grey as well.
constexpr std::array other_styles{
    LineStyle{"#d55e00", 2, ""}, LineStyle{"#005f46", 2, "8 4"},
    LineStyle{"#7b2d6b", 2, "3 3"}, LineStyle{"#222222", 1.6, "12 3 3 3"}};
constexpr std::size_t most_cutters = 3;
constexpr double shank_share = 0.5;  // height of the drawn shank over the radius
constexpr int arc_pieces = 24;

// A point of the drive plane in the axes of the figure, which looks along the plane's
// normal.
Vec3 placed(const SectionPoint& at)
{
    return {at.x(), 0, at.y()};
}

template <class Points, class PointOf>
std::vector<Vec3> placed(const Points& points, const PointOf& point_of)
{
    std::vector<Vec3> places;
    places.reserve(points.size());
    for (const auto& point : points)
        places.push_back(placed(point_of(point)));
    return places;
}

std::vector<Vec3> placed(const std::vector<SectionPoint>& points)
{
    return placed(points,
                  [](const SectionPoint& at) -> const SectionPoint& { return at; });
}

// The outline of the cutter from the left of the shank around the bottom to its right.
std::vector<Vec3> outline(const Cutter& cutter, const SectionPoint& reference)
{
    const double top = shank_share * cutter.radius();
    std::vector<Vec3> points{placed(reference + SectionPoint{-cutter.radius(), top})};
    for (const double side : {-1.0, 1.0})
        for (int k = 0; k <= arc_pieces; ++k) {
            const int step = side < 0 ? k : arc_pieces - k;
            const double angle = step * std::numbers::pi / 2 / arc_pieces;
            const double out =
                cutter.flat_radius() + cutter.corner_radius() * std::cos(angle);
            points.push_back(placed(
                reference +
                SectionPoint{side * out, -cutter.corner_radius() * std::sin(angle)}));
        }
    points.push_back(placed(reference + SectionPoint{cutter.radius(), top}));
    return points;
}

// Points at which the cutter is drawn: the first crossings, or the middle of the first
// curve.
std::vector<SectionPoint> cutter_places(std::span<const TrimmedCurve> curves)
{
    std::vector<SectionPoint> places;
    for (const TrimmedCurve& curve : curves)
        for (const TrimmedPoint& point : curve.points)
            if (point.kind == TrimmedKind::Crossing && places.size() < most_cutters)
                places.push_back(point.at);
    if (places.empty() && !curves.empty() && !curves.front().points.empty()) {
        const auto& points = curves.front().points;
        places.push_back(points[points.size() / 2].at);
    }
    return places;
}

// All points of the drawing, for its extent.
std::vector<Vec3> extent(const SectionDrawing& drawing,
                         std::span<const SectionPoint> cutters)
{
    std::vector<Vec3> points;
    const auto add = [&](const std::vector<Vec3>& more) {
        points.insert(points.end(), more.begin(), more.end());
    };
    for (const SectionCurve& curve : drawing.before)
        add(placed(curve.points));
    for (const auto& line : drawing.part)
        add(placed(line));
    if (drawing.cutter)
        for (const SectionPoint& at : cutters)
            add(outline(*drawing.cutter, at));
    return points;
}

// A square in the drive plane. Lines are cut at its sides.
class Window {
public:
    Window(const SectionPoint& centre, double half_side)
        : low_{centre - SectionPoint::Constant(half_side)},
          high_{centre + SectionPoint::Constant(half_side)}
    {
    }

    // The pieces of a line inside the square.
    std::vector<std::vector<Vec3>> inside(const std::vector<Vec3>& line) const
    {
        std::vector<std::vector<Vec3>> pieces;
        bool goes_on = false;
        for (std::size_t i = 0; i + 1 < line.size(); ++i) {
            const auto [from, to] = shares_inside(line[i], line[i + 1]);
            if (from > to) {
                goes_on = false;
                continue;
            }
            const Vec3 along = line[i + 1] - line[i];
            if (!goes_on)
                pieces.push_back({line[i] + from * along});
            pieces.back().push_back(line[i] + to * along);
            goes_on = to == 1;
        }
        return pieces;
    }

private:
    // The shares of a segment between which it is inside; the first exceeds the second if
    // it is outside.
    std::pair<double, double> shares_inside(const Vec3& a, const Vec3& b) const
    {
        double from = 0;
        double to = 1;
        for (const auto& [axis, low, high] :
             {std::tuple{0, low_.x(), high_.x()}, std::tuple{2, low_.y(), high_.y()}}) {
            const double along = b[axis] - a[axis];
            if (along == 0) {
                if (a[axis] < low || a[axis] > high)
                    return {1, 0};
                continue;
            }
            const double one = (low - a[axis]) / along;
            const double other = (high - a[axis]) / along;
            from = std::max(from, std::min(one, other));
            to = std::min(to, std::max(one, other));
        }
        return {from, to};
    }

    SectionPoint low_;
    SectionPoint high_;
};

// A section is drawn as a figure in space that is seen from the front; s becomes x.
FigureOptions seen_from_front(FigureOptions figure)
{
    figure.azimuth = Angle::degrees(-90);
    figure.elevation = Angle::degrees(0);
    figure.axis_names = {"s", "", "z"};
    figure.has_ticks = true;
    return figure;
}

}  // namespace

std::string section_svg(const SectionDrawing& drawing, FigureOptions figure)
{
    const std::vector<SectionPoint> cutters = cutter_places(drawing.after);
    AxonometricFigure picture{seen_from_front(std::move(figure)),
                              extent(drawing, cutters)};
    for (const auto& line : drawing.part)
        picture.add_curve(placed(line), part_style);
    for (const SectionCurve& curve : drawing.before)
        picture.add_curve(placed(curve.points), before_style);
    // The trimmed curves cover the others; red remains visible where a part was removed.
    for (const TrimmedCurve& curve : drawing.after)
        picture.add_curve(
            placed(curve.points, [](const TrimmedPoint& p) { return p.at; }),
            after_style);
    if (!drawing.part.empty())
        picture.add_legend("part", part_style);
    picture.add_legend("removed from the section (reference points)", before_style);
    picture.add_legend("trimmed section", after_style);
    if (drawing.cutter && !cutters.empty()) {
        for (const SectionPoint& at : cutters)
            picture.add_curve(outline(*drawing.cutter, at), cutter_style);
        picture.add_legend("cutter", cutter_style);
    }
    return picture.text();
}

namespace {

// A line to draw, and its style.
struct StyledLine {
    std::vector<Vec3> points;
    LineStyle style;
};

// All lines of a drawing, from back to front.
std::vector<StyledLine> lines_of(const ComparedSections& drawing, std::size_t others)
{
    std::vector<StyledLine> lines;
    for (const auto& line : drawing.part)
        lines.push_back({placed(line), part_style});
    const auto add = [&](std::span<const TrimmedCurve> curves, const LineStyle& style) {
        for (const TrimmedCurve& curve : curves)
            lines.push_back(
                {placed(curve.points, [](const TrimmedPoint& p) { return p.at; }),
                 style});
    };
    add(drawing.exact.curves, exact_style);
    for (const SectionCurve& curve : drawing.before)
        lines.push_back({placed(curve.points), untrimmed_style});
    for (std::size_t k = 0; k < others; ++k)
        add(drawing.others[k].curves, other_styles[k]);
    if (drawing.cutter)
        for (const SectionPoint& at : drawing.places)
            lines.push_back({outline(*drawing.cutter, at), cutter_style});
    return lines;
}

// The pieces of all lines inside the window of a drawing.
std::vector<StyledLine> visible_lines(const ComparedSections& drawing, std::size_t others)
{
    std::vector<StyledLine> lines = lines_of(drawing, others);
    if (drawing.places.empty() || !std::isfinite(drawing.half_side))
        return lines;
    const Window window{drawing.places.front(), drawing.half_side};
    std::vector<StyledLine> visible;
    for (const StyledLine& line : lines)
        for (auto& piece : window.inside(line.points))
            visible.push_back({std::move(piece), line.style});
    return visible;
}

}  // namespace

std::string compared_sections_svg(const ComparedSections& drawing, FigureOptions figure)
{
    const std::size_t count = std::min(drawing.others.size(), other_styles.size());
    const std::vector<StyledLine> lines = visible_lines(drawing, count);
    std::vector<Vec3> points;
    for (const StyledLine& line : lines)
        points.insert(points.end(), line.points.begin(), line.points.end());
    AxonometricFigure picture{seen_from_front(std::move(figure)), points};
    for (const StyledLine& line : lines)
        picture.add_curve(line.points, line.style);
    if (!drawing.part.empty())
        picture.add_legend("part", part_style);
    picture.add_legend("untrimmed section", untrimmed_style);
    picture.add_legend(drawing.exact.label, exact_style);
    if (drawing.cutter && !drawing.places.empty())
        picture.add_legend("cutter where they differ", cutter_style);
    for (std::size_t k = 0; k < count; ++k)
        picture.add_legend(drawing.others[k].label, other_styles[k]);
    return picture.text();
}

std::string curves_svg(std::span<const std::vector<Vec3>> curves,
                       const FigureOptions& figure)
{
    std::vector<Vec3> points;
    for (const auto& curve : curves)
        points.insert(points.end(), curve.begin(), curve.end());
    FigureOptions ticked = figure;
    ticked.has_ticks = true;
    AxonometricFigure picture{ticked, points};
    for (const auto& curve : curves)
        picture.add_curve(curve, curve_style);
    return picture.text();
}

}  // namespace endmill
