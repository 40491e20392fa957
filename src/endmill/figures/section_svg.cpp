// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/section_svg.h"

#include <cmath>
#include <cstddef>
#include <numbers>

// The curves before trimming are drawn in red, then the trimmed curves in blue and wider
// on top. Where trimming removed a part, the red curve remains visible.

namespace endmill {
namespace {

constexpr LineStyle before_style{"#d1402f", 1.2, ""};
constexpr LineStyle after_style{"#1d4f91", 2.2, ""};
constexpr LineStyle part_style{"#222222", 1.4, ""};
constexpr LineStyle cutter_style{"#8a6d1f", 1, "5 3"};
constexpr LineStyle curve_style{"#1d4f91", 0.8, ""};
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

}  // namespace

// The section is drawn as a figure in space that is seen from the front; s becomes x.
std::string section_svg(const SectionDrawing& drawing, FigureOptions figure)
{
    figure.azimuth = Angle::degrees(-90);
    figure.elevation = Angle::degrees(0);
    figure.axis_names = {"s", "", "z"};
    const std::vector<SectionPoint> cutters = cutter_places(drawing.after);
    AxonometricFigure picture{figure, extent(drawing, cutters)};
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

std::string curves_svg(std::span<const std::vector<Vec3>> curves,
                       const FigureOptions& figure)
{
    std::vector<Vec3> points;
    for (const auto& curve : curves)
        points.insert(points.end(), curve.begin(), curve.end());
    AxonometricFigure picture{figure, points};
    for (const auto& curve : curves)
        picture.add_curve(curve, curve_style);
    return picture.text();
}

}  // namespace endmill
