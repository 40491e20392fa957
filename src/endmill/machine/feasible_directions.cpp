// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/feasible_directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/detail/direction_cells.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double least_step = 1e-5;  // rad: a border has at most a few million points

double width(const RotaryRange& range)
{
    return range.to - range.from;
}

void require_range(const RotaryRange& range)
{
    require(range.from <= 0 && 0 <= range.to && width(range) <= 2 * pi + turn_tolerance,
            "FeasibleDirections: need limits that hold 0, at most 2 pi wide");
}

// The patches whose union is the set of tool directions. Azimuth and latitude refer to
// the pole in C,A and to R1 in A,B. C,A has the two sectors. A,B has the rectangle, and
// one patch behind R1 for each side on which R2 turns beyond 90 degrees.
std::vector<DirectionPatch> patches(RotaryFamily family, const RotaryLimits& limits)
{
    const RotaryRange& phi = limits.phi;
    const RotaryRange& theta = limits.theta;
    if (family == RotaryFamily::CA)
        return {{theta.from, width(theta), pi / 2 - phi.to, pi / 2},
                {theta.from + pi, width(theta), pi / 2 + phi.from, pi / 2}};
    std::vector<DirectionPatch> all{{phi.from, width(phi), std::max(theta.from, -pi / 2),
                                     std::min(theta.to, pi / 2)}};
    if (theta.to > pi / 2)
        all.push_back({phi.from + pi, width(phi), pi - theta.to, pi / 2});
    if (theta.from < -pi / 2)
        all.push_back({phi.from + pi, width(phi), -pi / 2, -pi - theta.from});
    return all;
}

RotaryAngles between(const RotaryAngles& from, const RotaryAngles& to, double share)
{
    return {from.phi + share * (to.phi - from.phi),
            from.theta + share * (to.theta - from.theta)};
}

// Points between two pairs of turns, at most `step` apart in each turn.
DirectionCurve sampled(const RotaryFrame& frame, const RotaryAngles& from,
                       const RotaryAngles& to, double step)
{
    const double length =
        std::max(std::abs(to.phi - from.phi), std::abs(to.theta - from.theta));
    const int pieces = static_cast<int>(std::ceil(length / step));
    DirectionCurve curve{turned_tool_axis(frame, from)};
    for (int k = 1; k <= pieces; ++k)
        curve.push_back(
            turned_tool_axis(frame, between(from, to, static_cast<double>(k) / pieces)));
    return curve;
}

RotaryAngles angles_at(RotaryFamily family, double azimuth, double latitude)
{
    if (family == RotaryFamily::CA)
        return {pi / 2 - latitude, azimuth};
    return {azimuth, latitude};
}

}  // namespace

FeasibleDirections::FeasibleDirections(const RotaryFrame& frame,
                                       const RotaryLimits& limits)
    : frame_{frame},
      limits_{limits}
{
    require_range(limits.phi);
    require_range(limits.theta);
    const RotaryRange& second =
        frame.family == RotaryFamily::CA ? limits.phi : limits.theta;
    require(std::max(second.to, -second.from) <= pi + turn_tolerance,
            "FeasibleDirections: need limits of the second axis within pi");
}

bool FeasibleDirections::contains(const Vec3& direction) const
{
    const RotaryAngles angles = rotary_angles(frame_, direction);
    const bool is_any = distance_from_singular(frame_, direction) <= turn_tolerance;
    for (const RotaryAngles& a : {angles, other_rotary_angles(frame_.family, angles)}) {
        const bool has_phi = turn_within(limits_.phi, a.phi).has_value();
        const bool has_theta = turn_within(limits_.theta, a.theta).has_value();
        const bool is_ca = frame_.family == RotaryFamily::CA;
        if ((has_phi || (is_any && !is_ca)) && (has_theta || (is_any && is_ca)))
            return true;
    }
    return false;
}

double FeasibleDirections::solid_angle() const
{
    return DirectionCells{patches(frame_.family, limits_)}.solid_angle();
}

std::vector<DirectionCurve> FeasibleDirections::border(double step) const
{
    require(step >= least_step, "FeasibleDirections::border: need a step from 1e-5");
    const RotaryRange& phi = limits_.phi;
    const RotaryRange& theta = limits_.theta;
    const bool is_thin = width(phi) <= thinnest_angle || width(theta) <= thinnest_angle;
    if (is_thin && frame_.family == RotaryFamily::CA && width(phi) <= thinnest_angle)
        return {{frame_.tool_axis}};
    if (is_thin)
        return {sampled(frame_, {phi.from, theta.from}, {phi.to, theta.to}, step)};
    std::vector<DirectionCurve> curves;
    for (const DirectionEdge& edge :
         DirectionCells{patches(frame_.family, limits_)}.border())
        curves.push_back(sampled(
            frame_, angles_at(frame_.family, edge.from_azimuth, edge.from_latitude),
            angles_at(frame_.family, edge.to_azimuth, edge.to_latitude), step));
    return curves;
}

FeasibleDirections feasible_directions(const MachineConfiguration& configuration,
                                       const RotaryLimits& limits)
{
    return {machine_frame(configuration), limits};
}

}  // namespace endmill
