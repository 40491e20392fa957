// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/candidate_charts.h"

#include <cmath>
#include <sstream>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/machine/feasible_directions.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/spherical_hull.h"

namespace endmill {
namespace {

ChartedDirections charted(const std::string& title, const DirectionSet& set,
                          ChartProjection projection)
{
    const PoleFrame frame{set.tool_axis};
    return {title, frame.pole, frame.x, set.directions, projection};
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
    return motion_chart(charted(title, set, ChartProjection::Equidistant), motion,
                        "sectors");
}

std::string rectangle_chart(const std::string& title, const DirectionSet& set,
                            const RectangleCandidate& rectangle)
{
    const Vec3 r2 = set.tool_axis.cross(rectangle.r1_axis);
    const FeasibleDirections motion{
        {RotaryFamily::AB, set.tool_axis, rectangle.r1_axis, r2},
        {rectangle.alpha, rectangle.beta}};
    return motion_chart(charted(title, set, ChartProjection::Gnomonic), motion,
                        "rectangle");
}

std::string hull_chart(const std::string& title, const DirectionSet& set,
                       ChartProjection projection)
{
    const bool is_gnomonic = projection == ChartProjection::Gnomonic;
    const std::vector<Vec3> hull = spherical_hull(
        set.tool_axis, set.directions,
        is_gnomonic ? HullProjection::Gnomonic : HullProjection::Orthographic);
    return hull_chart(charted(title, set, projection), hull);
}

}  // namespace endmill
