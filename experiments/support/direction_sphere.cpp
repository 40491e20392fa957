// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/direction_sphere.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "endmill/io/axonometric_figure.h"

namespace endmill {
namespace {

constexpr double radius_mm = 50;
constexpr double step = 0.01;  // rad: half a millimetre
constexpr std::string_view thin_dashes = "3 4";
constexpr LineStyle outline{"#999999", 1, {}};
constexpr LineStyle edge{"#0072B2", 2.5, {}};
constexpr LineStyle edge_behind{"#0072B2", 1.2, thin_dashes};
constexpr LineStyle first_axis{"#D55E00", 1.5, {}};
constexpr LineStyle second_axis{"#009E73", 1.5, {}};
constexpr LineStyle tool_line{"#000000", 2, {}};

// The great circle about `axis`.
std::vector<Vec3> circle(const Vec3& axis)
{
    const Vec3 across = axis.unitOrthogonal();
    const Vec3 other = axis.cross(across);
    std::vector<Vec3> points;
    for (int k = 0; k <= 360; ++k) {
        const double angle = 2 * std::numbers::pi * k / 360;
        points.push_back(radius_mm *
                         (std::cos(angle) * across + std::sin(angle) * other));
    }
    return points;
}

// The pieces of `curve` before and behind the sphere's outline.
void add_border(AxonometricFigure& figure, const DirectionCurve& curve)
{
    const Vec3& toward = figure.view().toward;
    std::vector<Vec3> piece;
    for (std::size_t i = 0; i < curve.size(); ++i) {
        piece.push_back(radius_mm * curve[i]);
        const bool is_front = curve[i].dot(toward) >= 0;
        const bool is_last = i + 1 == curve.size();
        if (is_last || (curve[i + 1].dot(toward) >= 0) != is_front) {
            figure.add_curve(piece, is_front ? edge : edge_behind);
            piece = {piece.back()};
        }
    }
    if (curve.size() == 1)
        figure.add_disc(radius_mm * curve[0], 5, edge.colour);
}

}  // namespace

std::string direction_sphere_svg(const FeasibleDirections& set, const std::string& title,
                                 const std::string& legend)
{
    const std::vector<Vec3> extent{{-60, -60, -50}, {60, 60, 65}};
    AxonometricFigure figure{{.title = title, .width_px = 600}, extent};
    figure.add_curve(circle(figure.view().toward), outline);
    const RotaryFrame& frame = set.frame();
    const bool is_ca = frame.family == RotaryFamily::CA;
    const RotaryLimits& limits = set.limits();
    figure.add_legend(legend, edge);
    // An axis that does not turn is none.
    const auto add_axis = [&](const char* name, const Vec3& axis,
                              const RotaryRange& range, const LineStyle& style) {
        if (range.from == range.to)
            return;
        const double reach = 1.2 * radius_mm;
        figure.add_curve(std::vector<Vec3>{-reach * axis, reach * axis}, style);
        figure.add_legend(name, style);
    };
    add_axis("R1", frame.r1_axis, is_ca ? limits.theta : limits.phi, first_axis);
    add_axis("R2", frame.r2_axis, is_ca ? limits.phi : limits.theta, second_axis);
    figure.add_curve(std::vector<Vec3>{Vec3::Zero(), 1.25 * radius_mm * frame.tool_axis},
                     tool_line);
    for (const DirectionCurve& curve : set.border(step))
        add_border(figure, curve);
    figure.add_disc(radius_mm * frame.tool_axis, 3.5, tool_line.colour);
    figure.add_legend("tool axis at zero, P", tool_line);
    return figure.text();
}

}  // namespace endmill
