// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/direction_figures.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/figures/detail/direction_chart.h"

// Both charts have the tool axis in the centre. The reach is chosen from the content: the
// smallest multiple of 5 degrees that contains all directions and borders, within the
// limit of the projection.

namespace endmill {
namespace {

constexpr double border_step = 0.01;  // rad
constexpr double reach_step_deg = 5;
// Beyond this reach a few more degrees would fill most of a gnomonic chart.
constexpr double gnomonic_reach_deg = 80;
constexpr double hemisphere_deg = 90;
constexpr double whole_sphere_deg = 180;
constexpr LineStyle border_style{"#e05a00", 2.5, ""};
constexpr LineStyle hull_style{"#0072b2", 2, ""};
constexpr LineStyle axis_style{"#b8006b", 1.5, "6 4"};
constexpr std::string_view mark_colour = "#222222";

// The smallest multiple of 5 degrees beyond the polar angles of all directions and
// borders, at most `most_deg`.
Angle reach_of(const ChartedDirections& chart, std::span<const DirectionCurve> borders,
               double most_deg)
{
    double least_cosine = 1;
    const auto take = [&](const Vec3& direction) {
        least_cosine = std::min(least_cosine, direction.dot(chart.pole));
    };
    std::ranges::for_each(chart.directions, take);
    for (const DirectionCurve& border : borders)
        std::ranges::for_each(border, take);
    const double polar_deg =
        Angle::radians(std::acos(std::max(least_cosine, -1.0))).degrees();
    const double round_deg =
        reach_step_deg * (std::floor(polar_deg / reach_step_deg) + 1);
    return Angle::degrees(std::min(round_deg, most_deg));
}

// The line towards the first rotary axis, which is at infinity in a gnomonic chart; it
// passes through the pole.
DirectionCurve line_to_first_axis(const Vec3& pole, const Vec3& r1_axis)
{
    constexpr int farthest_deg = 88;
    DirectionCurve line;
    for (int k = -farthest_deg; k <= farthest_deg; ++k) {
        const double turn = Angle::degrees(k).radians();
        line.emplace_back(std::cos(turn) * pole + std::sin(turn) * r1_axis);
    }
    return line;
}

}  // namespace

std::string motion_chart(const ChartedDirections& chart, const FeasibleDirections& motion,
                         std::string_view border_label)
{
    const auto borders = motion.border(border_step);
    const bool is_gnomonic = chart.projection == ChartProjection::Gnomonic;
    DirectionChart drawn{
        chart.title,
        {chart.pole, chart.right},
        chart.projection,
        reach_of(chart, borders, is_gnomonic ? gnomonic_reach_deg : whole_sphere_deg)};
    for (const DirectionCurve& border : borders)
        drawn.add_curve(border, border_style);
    if (is_gnomonic) {
        drawn.add_curve(line_to_first_axis(chart.pole, motion.frame().r1_axis),
                        axis_style);
        drawn.add_legend("towards R1", axis_style);
    }
    drawn.add_legend(border_label, border_style);
    drawn.add_marks(chart.directions, mark_colour, "directions");
    return drawn.text();
}

std::string hull_chart(const ChartedDirections& chart, std::span<const Vec3> hull)
{
    require(!hull.empty(), "hull_chart: need a vertex");
    const bool is_gnomonic = chart.projection == ChartProjection::Gnomonic;
    std::vector<Vec3> closed{hull.begin(), hull.end()};
    closed.push_back(hull.front());
    DirectionChart drawn{
        chart.title,
        {chart.pole, chart.right},
        chart.projection,
        reach_of(chart, {}, is_gnomonic ? hemisphere_deg - 1 : hemisphere_deg)};
    drawn.add_curve(closed, hull_style);
    drawn.add_legend("hull of the tool axis and the directions", hull_style);
    drawn.add_marks(chart.directions, mark_colour, "directions");
    return drawn.text();
}

}  // namespace endmill
