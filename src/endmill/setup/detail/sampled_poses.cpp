// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/sampled_poses.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/pose_search.h"

namespace endmill {
namespace {

// Steps in which a pose is turned about its tool axis. On a machine of three axes nothing
// else can be chosen; with C,A the turn matters only where both axes are in the head or
// the limits of C are narrow.
constexpr int three_axis_step_deg = 5;
constexpr int ca_step_deg = 30;

// A pose, and what orders it.
struct RankedPose {
    FittedPose fit;
    double objective;  // rad^2 or rad
};

Vec3 turned_about(const Vec3& axis, double angle, const Vec3& vector)
{
    return Eigen::AngleAxisd{angle, axis} * vector;
}

RotaryRange shifted(const RotaryRange& range, double by)
{
    return {range.from + by, range.to + by};
}

// Turns a pose of the family C,A about its tool axis by `angle`. Azimuths then decrease
// by the angle. If the window leaves the limits of C, the opposite sector may serve.
std::optional<FittedPose> turned_ca(FittedPose fit, double angle,
                                    const RotaryLimits& limits)
{
    fit.pose.r2_axis = turned_about(fit.pose.tool_axis, angle, fit.pose.r2_axis);
    constexpr double pi = std::numbers::pi;
    for (const double by : {-angle, 2 * pi - angle}) {
        const RotaryRange theta = shifted(fit.theta, by);
        if (is_within(fit.phi, limits.phi) && is_within(theta, limits.theta)) {
            fit.theta = theta;
            return fit;
        }
    }
    for (const double by : {pi - angle, -pi - angle}) {
        const RotaryRange theta = shifted(fit.theta, by);
        const RotaryRange phi = turned(fit.phi);
        if (is_within(phi, limits.phi) && is_within(theta, limits.theta)) {
            fit.phi = phi;
            fit.theta = theta;
            return fit;
        }
    }
    return std::nullopt;
}

// Turns a pose of the family A,B by 180 degrees about its tool axis.
std::optional<FittedPose> turned_ab(FittedPose fit, const RotaryLimits& limits)
{
    fit.pose.r1_axis = -fit.pose.r1_axis;
    fit.pose.r2_axis = -fit.pose.r2_axis;
    fit.phi = turned(fit.phi);
    fit.theta = turned(fit.theta);
    if (!is_within(fit.phi, limits.phi) || !is_within(fit.theta, limits.theta))
        return std::nullopt;
    return fit;
}

std::vector<FittedPose> five_axis_poses(const SphereGrid& grid, const VisibilityMap& map,
                                        const PoseSampling& sampling)
{
    const PoseFitOptions options{.family = sampling.reach.configuration.family.value(),
                                 .mode = sampling.mode,
                                 .limits = sampling.reach.limits,
                                 .order = rotary_order(sampling.reach.configuration),
                                 .nearest_cells = sampling.nearest_cells};
    const RotaryLimits& limits = sampling.reach.limits;
    std::vector<FittedPose> poses;
    for (const FittedPose& fit :
         poses_within_limits(map_of_distinct_cones(map), grid.centres, options)) {
        poses.push_back(fit);
        if (options.family == RotaryFamily::AB) {
            if (const auto turned = turned_ab(fit, limits))
                poses.push_back(*turned);
            continue;
        }
        for (int angle = ca_step_deg; angle < 360; angle += ca_step_deg)
            if (const auto turned =
                    turned_ca(fit, Angle::degrees(angle).radians(), limits))
                poses.push_back(*turned);
    }
    return poses;
}

std::vector<FittedPose> three_axis_poses(const SphereGrid& grid,
                                         const PartVisibility& visibility)
{
    const VisibilityMap& map = visibility.map;
    const std::size_t all = map.facets() - visibility.dropped.size();
    std::vector<FittedPose> poses;
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        std::size_t reached = 0;
        for (const std::uint64_t word : map.column(cell))
            reached += static_cast<std::size_t>(std::popcount(word));
        if (reached < all)
            continue;
        const FittedPose first = pose_without_rotary_axes(grid, cell);
        for (int angle = 0; angle < 180; angle += three_axis_step_deg) {
            FittedPose turned = first;
            for (Vec3* axis : {&turned.pose.r1_axis, &turned.pose.r2_axis})
                *axis = turned_about(turned.pose.tool_axis,
                                     Angle::degrees(angle).radians(), *axis);
            poses.push_back(turned);
        }
    }
    return poses;
}

// Sorts by the objective. Poses whose objective counts as equal to that of the first of
// them are sorted by the sum of their ranges.
std::vector<FittedPose> in_order(const std::vector<FittedPose>& poses,
                                 const PoseSampling& sampling)
{
    std::vector<RankedPose> ranked;
    ranked.reserve(poses.size());
    for (const FittedPose& fit : poses)
        ranked.push_back({fit, objective_of(fit, sampling)});
    std::ranges::stable_sort(ranked, {}, &RankedPose::objective);
    for (auto first = ranked.begin(); first != ranked.end();) {
        const double limit = equal_area_limit(first->objective);
        const auto end = std::find_if(first, ranked.end(), [&](const RankedPose& pose) {
            return pose.objective > limit;
        });
        std::stable_sort(first, end, [](const RankedPose& a, const RankedPose& b) {
            return score_of(a.fit).sum < score_of(b.fit).sum;
        });
        first = end;
    }
    std::vector<FittedPose> sorted;
    sorted.reserve(ranked.size());
    for (const RankedPose& pose : ranked)
        sorted.push_back(pose.fit);
    return sorted;
}

}  // namespace

RotaryFamily family_of(const MachineConfiguration& configuration)
{
    return configuration.family.value_or(RotaryFamily::AB);
}

double objective_of(const FittedPose& pose, const PoseSampling& sampling)
{
    if (!sampling.measure)
        return pose.area;
    return (*sampling.measure)(
        pose_ranges(family_of(sampling.reach.configuration), pose));
}

std::vector<Vec3> four_axis_axes()
{
    return sphere_grid("ico:4").centres;
}

FittedPose pose_without_rotary_axes(const SphereGrid& grid, std::size_t cell)
{
    const Vec3 axis = grid.centres[cell];
    const Vec3 across = axis.unitOrthogonal();
    return {{axis, across, axis.cross(across)}, {0, 0}, {0, 0}, 0, cell};
}

bool is_same_pose(const SetupPose& one, const SetupPose& other)
{
    return one.tool_axis == other.tool_axis && one.r1_axis == other.r1_axis &&
           one.r2_axis == other.r2_axis;
}

std::vector<FittedPose> sampled_poses(const SphereGrid& grid,
                                      const PartVisibility& visibility,
                                      const PoseSampling& sampling)
{
    const MachineConfiguration& configuration = sampling.reach.configuration;
    if (configuration.family)
        return in_order(five_axis_poses(grid, visibility.map, sampling), sampling);
    if (configuration.rotary.empty())
        return in_order(three_axis_poses(grid, visibility), sampling);
    return in_order(
        arcs_within_limits(visibility.map, grid.centres, four_axis_axes(),
                           sampling.reach.limits.phi, sampling.reach.arc_tolerance),
        sampling);
}

}  // namespace endmill
