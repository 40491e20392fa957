// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/direction_figures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/figures/axonometric_figure.h"

// The sphere is drawn from back to front: the rotary axes that pass through it, the
// ground of the sphere, the set as small patches, the circles and borders, then the
// visible ends of the axes and the names. The parts of lines behind the sphere are
// dashed.

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double step = 0.01;      // step of borders, rad
constexpr double patch = pi / 45;  // largest side of the patches that fill the set, rad
constexpr double seam_px = 0.6;    // outline that hides anti-aliased gaps between patches
constexpr double axis_reach = 1.25;   // length of axes, in radii of the sphere
constexpr double label_reach = 1.36;  // distance of names from the centre, in radii
constexpr double label_gap_px = 20;
constexpr std::string_view thin_dashes = "3 4";
constexpr std::string_view ground = "#f6f7f8";
constexpr std::string_view inside = "#cfe3f2";
constexpr LineStyle outline{"#999999", 1, {}};
constexpr LineStyle circle_line{"#777777", 1.2, {}};
constexpr LineStyle edge{"#0072B2", 2.5, {}};
constexpr LineStyle first_axis{"#b8006b", 2, {}};
constexpr LineStyle second_axis{"#00785a", 2, {}};
constexpr LineStyle tool_line{"#000000", 2, {}};

// The style of a line behind the sphere: thin and dashed.
LineStyle behind(const LineStyle& style)
{
    return {style.colour, std::min(style.width_px, 1.2), thin_dashes};
}

// The great circle across a direction, closed.
DirectionCurve great_circle(const Vec3& normal)
{
    const Vec3 across = normal.unitOrthogonal();
    const Vec3 other = normal.cross(across);
    DirectionCurve points;
    for (int k = 0; k <= 360; ++k) {
        const double angle = 2 * pi * k / 360;
        points.emplace_back(std::cos(angle) * across + std::sin(angle) * other);
    }
    return points;
}

// A rotary axis, R1 or R2, whose range is not a single position.
struct TurningAxis {
    const char* name;
    Vec3 axis;
    LineStyle style;
};

// Collects the drawing of one set. Lengths are in radii of the sphere.
class DirectionSphere {
public:
    // An axis whose range is a single position is not drawn, since it does not turn.
    DirectionSphere(const FeasibleDirections& set, const std::string& title)
        : set_{set},
          frame_{set.frame()},
          limits_{set.limits()},
          is_ca_{frame_.family == RotaryFamily::CA},
          figure_{{.title = title, .width_px = 640, .has_length = false}, extent()}
    {
        const RotaryRange& first = is_ca_ ? limits_.theta : limits_.phi;
        const RotaryRange& second = is_ca_ ? limits_.phi : limits_.theta;
        if (first.from != first.to)
            axes_.push_back({"R1", frame_.r1_axis, first_axis});
        if (second.from != second.to)
            axes_.push_back({"R2", frame_.r2_axis, second_axis});
    }

    // Draws everything from back to front.
    std::string text(const std::string& legend)
    {
        for (const TurningAxis& axis : axes_)
            figure_.add_curve(
                std::array<Vec3, 2>{-axis_reach * axis.axis, axis_reach * axis.axis},
                axis.style);
        figure_.add_polygon(great_circle(figure_.view().toward), ground, outline);
        fill();
        figure_.add_curve(great_circle(figure_.view().toward), outline);
        add_circles();
        for (const DirectionCurve& curve : set_.border(step))
            add_line(curve, edge);
        for (const TurningAxis& axis : axes_)
            add_ends(axis);
        add_pole();
        if (axes_.size() == 2)
            add_names();
        add_legend(legend);
        return figure_.text();
    }

private:
    // Points that bound the sphere, the axes and their names.
    static std::vector<Vec3> extent()
    {
        const AxonometricView view{FigureOptions{}.azimuth, FigureOptions{}.elevation};
        return {-label_reach * view.right, label_reach * view.right, -1.1 * view.up,
                label_reach * view.up};
    }

    // Whether a direction is on the front half of the sphere.
    bool is_front(const Vec3& direction) const
    {
        return direction.dot(figure_.view().toward) >= 0;
    }

    // Draws a curve; the pieces behind the sphere are dashed.
    void add_line(const DirectionCurve& curve, const LineStyle& style)
    {
        DirectionCurve piece;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            piece.push_back(curve[i]);
            const bool is_last = i + 1 == curve.size();
            if (is_last || is_front(curve[i + 1]) != is_front(curve[i])) {
                figure_.add_curve(piece, is_front(curve[i]) ? style : behind(style));
                piece = {piece.back()};
            }
        }
    }

    // Fills the set in front of the outline. Corners behind the outline are moved onto
    // it.
    void fill()
    {
        const auto count = [](const RotaryRange& range) {
            return static_cast<int>(std::ceil((range.to - range.from) / patch));
        };
        const int across = count(limits_.phi);
        const int along = count(limits_.theta);
        for (int i = 0; i < across; ++i)
            for (int k = 0; k < along; ++k) {
                std::vector<Vec3> corners;
                for (const auto& [di, dk] :
                     {std::pair{0, 0}, std::pair{1, 0}, std::pair{1, 1}, std::pair{0, 1}})
                    corners.push_back(
                        at(double(i + di) / across, double(k + dk) / along));
                if (std::ranges::none_of(corners,
                                         [&](const Vec3& v) { return is_front(v); }))
                    continue;
                for (Vec3& v : corners)
                    if (!is_front(v))
                        v = (v - v.dot(figure_.view().toward) * figure_.view().toward)
                                .normalized();
                figure_.add_polygon(corners, inside, {inside, seam_px, ""});
            }
    }

    // The direction at the given shares, 0 to 1, of the ranges of phi and theta.
    Vec3 at(double phi, double theta) const
    {
        const auto share = [](const RotaryRange& range, double of) {
            return range.from + of * (range.to - range.from);
        };
        return turned_tool_axis(frame_,
                                {share(limits_.phi, phi), share(limits_.theta, theta)});
    }

    // Draws the basis circle, which the tool follows when only the tilt (C,A) or only R1
    // (A,B) moves. For A,B also draws the great circles of E1 and E2.
    void add_circles()
    {
        if (axes_.empty())
            return;
        add_line(great_circle(is_ca_ ? frame_.r2_axis : frame_.r1_axis), circle_line);
        if (!has_meridians())
            return;
        for (const double phi : {limits_.phi.from, limits_.phi.to}) {
            const Vec3 middle = turned_tool_axis(frame_, {phi, 0});
            add_line(great_circle(middle.cross(frame_.r1_axis)), circle_line);
        }
    }

    // Whether the set has the edges E1 and E2.
    bool has_meridians() const
    {
        return !is_ca_ && axes_.size() == 2 && !goes_round(limits_.phi);
    }

    // Whether a range is a whole turn, so that it has no ends.
    static bool goes_round(const RotaryRange& range)
    {
        return range.to - range.from >= 2 * pi - equal_angles;
    }

    // Draws the visible ends of an axis and its name, with a minus sign at the negative
    // end.
    void add_ends(const TurningAxis& axis)
    {
        for (const double side : {-1.0, 1.0}) {
            const Vec3 end = side * axis.axis;
            if (!is_front(end))
                continue;
            figure_.add_curve(std::array<Vec3, 2>{end, axis_reach * end}, axis.style);
            figure_.add_disc(end, 4, axis.style.colour);
        }
        const bool is_turned = !is_front(axis.axis);
        const Vec3 end = is_turned ? Vec3{-axis.axis} : axis.axis;
        if ((axis.axis - frame_.tool_axis).norm() > equal_angles)
            figure_.add_label(label_reach * end, {0, 0},
                              (is_turned ? "−" : "") + std::string{axis.name},
                              axis.style.colour);
    }

    // Draws the tool axis at zero, P.
    void add_pole()
    {
        const Vec3& pole = frame_.tool_axis;
        figure_.add_curve(std::array<Vec3, 2>{pole, axis_reach * pole}, tool_line);
        figure_.add_disc(pole, 4, tool_line.colour);
        figure_.add_label(pole, {-12, -10}, "P", tool_line.colour);
        const bool is_first = is_ca_ && !axes_.empty();
        figure_.add_label(label_reach * pole, {0, 0}, is_first ? "tool, R1" : "tool",
                          tool_line.colour);
    }

    // A name beside a direction, away from the middle of the set.
    void add_name(const Vec3& direction, const Vec3& middle, std::string_view name)
    {
        if (!is_front(direction))
            return;
        const Vec3 away = direction - middle;
        const PixelPoint out{away.dot(figure_.view().right),
                             -away.dot(figure_.view().up)};
        figure_.add_label(direction, label_gap_px * out.normalized(), name, edge.colour);
    }

    // Writes the names of [KangSuh, figure 5] at edges and corners where the ranges end.
    void add_names()
    {
        if (is_ca_ && !goes_round(limits_.theta)) {
            const double far = limits_.phi.to >= -limits_.phi.from ? 1 : 0;
            add_name(at(far, 1), at(far / 2, 0.5), "CR1");
            add_name(at(far, 0), at(far / 2, 0.5), "CR2");
        }
        if (is_ca_)
            return;
        const Vec3 middle = at(0.5, 0.5);
        if (!goes_round(limits_.phi)) {
            add_name(at(1, 0.5), middle, "E1");
            add_name(at(0, 0.5), middle, "E2");
        }
        if (!goes_round(limits_.theta)) {
            add_name(at(0.5, 1), middle, "E3");
            add_name(at(0.5, 0), middle, "E4");
        }
    }

    // The legend names only what is drawn.
    void add_legend(const std::string& legend)
    {
        if (axes_.empty())
            figure_.add_legend("the only direction, P", {tool_line.colour, 8, ""});
        else
            figure_.add_legend(legend, edge);
        for (const TurningAxis& axis : axes_)
            figure_.add_legend(axis.name, axis.style);
        if (!axes_.empty())
            figure_.add_legend(
                has_meridians() ? "basis circle, EG1, EG2" : "basis circle", circle_line);
    }

    FeasibleDirections set_;
    RotaryFrame frame_;
    RotaryLimits limits_;
    bool is_ca_;
    AxonometricFigure figure_;
    std::vector<TurningAxis> axes_;
};

}  // namespace

std::string direction_sphere_svg(const FeasibleDirections& set, const std::string& title,
                                 const std::string& legend)
{
    return DirectionSphere{set, title}.text(legend);
}

}  // namespace endmill
