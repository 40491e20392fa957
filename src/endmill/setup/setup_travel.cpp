// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_travel.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <tuple>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/machine/axis_limits.h"

namespace endmill {
namespace {

// A cell within the limits and its turns.
struct ReachableCell {
    double turned;  // rad, |phi| + |theta|
    FacetReach reach;
};

// The solution for a direction that is within the limits; of two the one of less |phi| +
// |theta|.
std::optional<ReachableCell> reachable(const RotaryFrame& frame,
                                       const RotaryLimits& limits, const Vec3& direction,
                                       std::size_t cell)
{
    RotaryAngles one = rotary_angles(frame, direction);
    // At a singular direction one rotation has no effect, and rounding would decide it.
    if (distance_from_singular(frame, direction) <= turn_tolerance)
        (frame.family == RotaryFamily::CA ? one.theta : one.phi) = 0;
    std::optional<ReachableCell> best;
    for (const RotaryAngles& angles : {one, other_rotary_angles(frame.family, one)}) {
        const std::optional<double> phi = turn_within(limits.phi, angles.phi);
        const std::optional<double> theta = turn_within(limits.theta, angles.theta);
        if (!phi || !theta)
            continue;
        const double turned = std::abs(*phi) + std::abs(*theta);
        if (!best || turned < best->turned)
            best = ReachableCell{turned, {cell, {*phi, *theta}}};
    }
    return best;
}

// All cells within the limits, sorted by |phi| + |theta|, then by their numbers.
std::vector<ReachableCell> by_turns(std::span<const Vec3> centres,
                                    const RotaryFrame& frame, const RotaryLimits& limits)
{
    std::vector<ReachableCell> cells;
    for (std::size_t i = 0; i < centres.size(); ++i)
        if (const auto cell = reachable(frame, limits, centres[i], i))
            cells.push_back(*cell);
    std::ranges::sort(cells, {}, [](const ReachableCell& cell) {
        return std::tuple{cell.turned, cell.reach.cell};
    });
    return cells;
}

// The middle of the travel; 0 for an axis without limits.
Vec3 middle(const LinearLimits& limits)
{
    Vec3 middle = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const double sum = limits[k].from + limits[k].to;
        middle[k] = std::isfinite(sum) ? sum / 2 : 0;
    }
    return middle;
}

}  // namespace

Eigen::Matrix3d part_to_machine(const SetupPose& pose,
                                const MachineConfiguration& configuration)
{
    require(configuration.is_valid(), "part_to_machine: need a valid configuration");
    // One rotary axis is perpendicular to the tool axis, so that it is X or Y; the
    // remaining row follows from it and Z. In C,A this is the second axis, in A,B the
    // first one. A machine without rotary axes has r1 as X.
    const auto& rotary = configuration.rotary;
    const bool is_ca = configuration.family == RotaryFamily::CA;
    const char letter = rotary.empty() ? 'a' : rotary[is_ca ? 1 : 0].letter;
    const Vec3& across = is_ca ? pose.r2_axis : pose.r1_axis;
    const bool is_x = letter == 'a';
    Eigen::Matrix3d rows;
    rows.row(is_x ? 0 : 1) = across;
    rows.row(is_x ? 1 : 0) =
        is_x ? pose.tool_axis.cross(across) : across.cross(pose.tool_axis);
    rows.row(2) = pose.tool_axis;
    return rows;
}

std::vector<std::optional<FacetReach>> facet_reach(const VisibilityMap& map,
                                                   std::span<const Vec3> centres,
                                                   const RotaryFrame& frame,
                                                   const RotaryLimits& limits)
{
    require(centres.size() == map.cells(), "facet_reach: need a centre for each cell");
    std::vector<std::optional<FacetReach>> reaches(map.facets());
    std::vector<std::uint64_t> left(map.words(), ~std::uint64_t{0});
    for (const ReachableCell& cell : by_turns(centres, frame, limits)) {
        const std::span<const std::uint64_t> column = map.column(cell.reach.cell);
        for (std::size_t w = 0; w < map.words(); ++w) {
            for (std::uint64_t bits = column[w] & left[w]; bits != 0; bits &= bits - 1)
                reaches[64 * w + static_cast<std::size_t>(std::countr_zero(bits))] =
                    cell.reach;
            left[w] &= ~column[w];
        }
    }
    return reaches;
}

std::optional<ReachedPoints> reached_points(const TriangleMesh& part,
                                            const PartVisibility& visibility,
                                            std::span<const Vec3> centres,
                                            const RotaryFrame& frame,
                                            const RotaryLimits& limits)
{
    const auto reaches = facet_reach(visibility.map, centres, frame, limits);
    ReachedPoints reached;
    for (std::size_t j = 0; j < reaches.size(); ++j) {
        if (!reaches[j])
            continue;
        const auto [a, b, c] = part.corners(j);
        reached.points.push_back((a + b + c) / 3);
        reached.angles.push_back(reaches[j]->angles);
    }
    const std::size_t with_area = reaches.size() - visibility.dropped.size();
    if (reached.points.empty() || reached.points.size() < with_area)
        return std::nullopt;
    return reached;
}

RotaryPositions rotary_positions(const MachineConfiguration& configuration,
                                 const RotaryAngles& angles)
{
    RotaryLimits turns;
    turns.phi.to = angles.phi;
    turns.theta.to = angles.theta;
    RotaryPositions positions{0, 0};
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k)
        positions[k] =
            mirrored(configuration.rotary[k].side, turns_of(turns, configuration, k).to);
    return positions;
}

SetupTravel setup_travel(const Machine& machine, const Eigen::Matrix3d& part_to_machine,
                         const ReachedPoints& reached, const Vec3& clamp,
                         double tool_length)
{
    require(!reached.points.empty(), "setup_travel: need a point");
    require(reached.points.size() == reached.angles.size(),
            "setup_travel: need one pair of turns for each point");
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const Vec3 centre = middle(machine.linear);
    SetupTravel travel{Vec3::Constant(infinity), Vec3::Constant(-infinity), true,
                       Vec3::Zero()};
    Vec3 shift = Vec3::Zero();
    for (std::size_t i = 0; i < reached.points.size(); ++i) {
        const RotaryPositions rotary =
            rotary_positions(machine.configuration, reached.angles[i]);
        const Vec3 point = part_to_machine * reached.points[i] + clamp;
        const Vec3 xyz = axis_positions(machine, rotary, point, tool_length).xyz;
        travel.low = travel.low.cwiseMin(xyz);
        travel.high = travel.high.cwiseMax(xyz);
        travel.is_within = travel.is_within && is_within(machine.linear, xyz);
        // A position is X = G p' + constant with the turn G of the part. It moves to the
        // middle of the travel if the point p' moves by G^T (middle - X).
        const Vec3 met = tool_location(machine, {rotary, centre}, tool_length).tip;
        shift += met - point;
    }
    travel.centred_clamp = clamp + shift / static_cast<double>(reached.points.size());
    return travel;
}

}  // namespace endmill
