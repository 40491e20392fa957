// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/candidate_charts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/spherical_hull.h"

namespace endmill {
namespace {

constexpr double border_step = 0.01;  // rad
constexpr double reach_step_deg = 5;
constexpr double gnomonic_reach_deg =
    80;  // beyond, a little more takes most of the picture
constexpr LineStyle border_style{"#e05a00", 2.5, ""};
constexpr LineStyle hull_style{"#0072b2", 2, ""};
constexpr LineStyle axis_style{"#b8006b", 1.5, "6 4"};
constexpr std::string_view mark_colour = "#222222";

DirectionChart::Frame frame_of(const DirectionSet& set)
{
    const PoleFrame frame{set.tool_axis};
    return {frame.pole, frame.x};
}

// A round angle that all directions are within.
Angle reach_of(const DirectionSet& set, std::span<const DirectionCurve> borders,
               double most_deg)
{
    double least_cosine = 1;
    const auto take = [&](const Vec3& direction) {
        least_cosine = std::min(least_cosine, direction.dot(set.tool_axis));
    };
    std::ranges::for_each(set.directions, take);
    for (const DirectionCurve& border : borders)
        std::ranges::for_each(border, take);
    const double polar_deg =
        Angle::radians(std::acos(std::max(least_cosine, -1.0))).degrees();
    const double round_deg =
        reach_step_deg * (std::floor(polar_deg / reach_step_deg) + 1);
    return Angle::degrees(std::min(round_deg, most_deg));
}

std::string chart_with_borders(const std::string& title, const DirectionSet& set,
                               const FeasibleDirections& motion,
                               ChartProjection projection)
{
    const auto borders = motion.border(border_step);
    const bool is_gnomonic = projection == ChartProjection::Gnomonic;
    DirectionChart chart{title, frame_of(set), projection,
                         reach_of(set, borders, is_gnomonic ? gnomonic_reach_deg : 180)};
    for (const DirectionCurve& border : borders)
        chart.add_curve(border, border_style);
    if (is_gnomonic) {
        // R1 is at infinity: the line towards it goes through the tool axis.
        DirectionCurve line;
        for (int k = -88; k <= 88; ++k) {
            const double turn = Angle::degrees(k).radians();
            line.emplace_back(std::cos(turn) * set.tool_axis +
                              std::sin(turn) * motion.frame().r1_axis);
        }
        chart.add_curve(line, axis_style);
        chart.add_legend("towards R1", axis_style);
    }
    chart.add_legend(is_gnomonic ? "rectangle" : "sectors", border_style);
    chart.add_marks(set.directions, mark_colour, "directions");
    return chart.text();
}

}  // namespace

DirectionSet direction_set(const std::string& text)
{
    DirectionSet set{Vec3::UnitZ(), {}};
    const RotaryFrame ab{RotaryFamily::AB, Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        const std::size_t between = word.find_first_of(":/");
        require(between != std::string::npos, "direction_set: need two angles a word");
        const auto first_deg = number_from_text(word.substr(0, between));
        const auto second_deg = number_from_text(word.substr(between + 1));
        require(first_deg && second_deg, "direction_set: need two numbers a word");
        const double first = Angle::degrees(*first_deg).radians();
        const double second = Angle::degrees(*second_deg).radians();
        if (word[between] == '/')
            set.directions.push_back(turned_tool_axis(ab, {first, second}));
        else
            set.directions.emplace_back(std::sin(second) * std::cos(first),
                                        std::sin(second) * std::sin(first),
                                        std::cos(second));
    }
    return set;
}

std::string sector_chart(const std::string& title, const DirectionSet& set,
                         const SectorCandidate& sector)
{
    const PoleFrame frame{set.tool_axis};
    const double half = sector.width / 2;
    const Vec3 r2 = frame.pole.cross(frame.equator(sector.from + half));
    const FeasibleDirections motion{
        {RotaryFamily::CA, frame.pole, frame.pole, r2},
        {{-sector.opposite_polar, sector.polar}, {-half, half}}};
    return chart_with_borders(title, set, motion, ChartProjection::Equidistant);
}

std::string rectangle_chart(const std::string& title, const DirectionSet& set,
                            const RectangleCandidate& rectangle)
{
    const Vec3 r2 = set.tool_axis.cross(rectangle.r1_axis);
    const FeasibleDirections motion{
        {RotaryFamily::AB, set.tool_axis, rectangle.r1_axis, r2},
        {rectangle.alpha, rectangle.beta}};
    return chart_with_borders(title, set, motion, ChartProjection::Gnomonic);
}

std::string hull_chart(const std::string& title, const DirectionSet& set,
                       ChartProjection projection)
{
    const bool is_gnomonic = projection == ChartProjection::Gnomonic;
    std::vector<Vec3> hull = spherical_hull(
        set.tool_axis, set.directions,
        is_gnomonic ? HullProjection::Gnomonic : HullProjection::Orthographic);
    hull.push_back(hull.front());
    DirectionChart chart{title, frame_of(set), projection,
                         reach_of(set, {}, is_gnomonic ? 89 : 90)};
    chart.add_curve(hull, hull_style);
    chart.add_legend("hull of the tool axis and the directions", hull_style);
    chart.add_marks(set.directions, mark_colour, "directions");
    return chart.text();
}

}  // namespace endmill
