// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/sector_fit.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/setup_rules.h"
#include "endmill/setup/detail/wide_sectors.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

// Calls `take` for each narrow sector whose counter-clockwise end is a direction. The
// double sector leaves out the larger of two gaps: after the direction, or after its
// antipode. Both indices only grow from one direction to the next. Source: [KangSuh, eq.
// (6)-(11)].
template <class Take>
void for_each_narrow_sector(const DirectionFan& fan, const Take& take)
{
    const std::size_t count = fan.size();
    if (count == 0)
        take(fan.candidate(0, 0, 0, 0));
    std::size_t beyond = 0;  // the first direction after the antipode of the end
    std::size_t first = 0;   // the first direction in the sector that ends at j + count
    RunMaximum inside{fan};
    RunMaximum outside{fan};
    for (std::size_t j = 0; j < count; ++j) {
        const double end = fan.azimuth(j);
        beyond = std::max(beyond, j + 1);
        while (beyond < j + count && fan.azimuth(beyond) <= end + pi + equal_angles)
            ++beyond;
        const double gap =
            std::min({fan.azimuth(j + 1) - end, fan.azimuth(beyond) - (end + pi), pi});
        const double width = std::max(pi - gap, 0.0);
        first = std::max(first, j + 1);
        while (first < j + count &&
               fan.azimuth(first) < end + 2 * pi - width - equal_angles)
            ++first;
        take(fan.candidate(end - width, width, inside.of(first, j + count + 1),
                           outside.of(j + 1, first)));
    }
}

// Calls `take` for each sector of 180 degrees or more from one direction to another. At
// exactly 180 degrees it differs from the narrow sector, which has the two directions in
// different sectors.
template <class Take>
void for_each_wide_sector(const DirectionFan& fan, const Take& take)
{
    const std::size_t count = fan.size();
    // outside[k]: largest polar angle of the directions after the k-th from j.
    std::vector<double> outside(count, 0.0);
    for (std::size_t j = 0; j < count; ++j) {
        for (std::size_t k = count - 1; k > 0; --k)
            outside[k - 1] = std::max(outside[k], fan.polar(j + k));
        double inside = 0;
        for (std::size_t k = 0; k < count; ++k) {
            inside = std::max(inside, fan.polar(j + k));
            const double width = fan.azimuth(j + k) - fan.azimuth(j);
            if (width >= pi - equal_angles)
                take(fan.candidate(fan.azimuth(j), width, inside, outside[k]));
        }
    }
}

RotaryRange tilt(const SectorCandidate& sector)
{
    return {0 - sector.opposite_polar, sector.polar};
}

// Tests whether the machine reaches the sectors. The zero of C is free, so that only the
// width of C and the magnitudes of the tilts are compared.
bool is_feasible(const SectorCandidate& sector, const RotaryLimits& limits)
{
    return is_within_unsigned(tilt(sector), limits.phi) &&
           sector.width <= limits.theta.to - limits.theta.from + equal_angles;
}

// Tests whether the first sector gets the positive tilt.
bool is_first_positive(const SectorCandidate& sector, const RotaryRange& limits)
{
    const bool fits = is_within(tilt(sector), limits);
    if (fits != is_within(turned(tilt(sector)), limits))
        return fits;
    return sector.polar >= sector.opposite_polar;
}

FittedPose fitted_pose(const PoleFrame& frame, const SectorCandidate& sector,
                       const RotaryLimits& limits)
{
    const bool is_first = is_first_positive(sector, limits.phi);
    const double room = limits.theta.to - limits.theta.from;
    // Source: [KangSuh, eq. (9)].
    const double before = room > 0 ? sector.width * limits.theta.from / room : 0;
    const double begin = is_first ? sector.from : sector.from + pi;
    const Vec3 zero = frame.equator(begin - before);
    FittedPose fit;
    fit.pose = {frame.pole, frame.pole, frame.pole.cross(zero)};
    fit.phi = is_first ? tilt(sector) : turned(tilt(sector));
    fit.theta = {before, before + sector.width};
    fit.area = sector.area();
    return fit;
}

}  // namespace

std::vector<SectorCandidate> sector_candidates(const Vec3& tool_axis,
                                               std::span<const Vec3> directions,
                                               SetupMode mode)
{
    std::vector<SectorCandidate> result;
    const DirectionFan fan{PolePoints{tool_axis, directions}};
    const auto take = [&result](const SectorCandidate& sector) {
        result.push_back(sector);
    };
    for_each_narrow_sector(fan, take);
    if (setup_rules(mode).has_wide_sectors)
        for_each_wide_sector(fan, take);
    return result;
}

PoseSearchResult sector_fit(const Vec3& tool_axis, std::span<const Vec3> directions,
                            const PoseFitOptions& options, const AreaBounds& bounds)
{
    check_pose_fit_options(options);
    require(options.family == RotaryFamily::CA, "sector_fit: need the family C,A");
    const PolePoints points{tool_axis, directions};
    const DirectionFan fan{points};
    BestCandidate<SectorCandidate> least{bounds.least};
    BestCandidate<SectorCandidate> feasible{bounds.feasible};
    const auto is_allowed = [&](const SectorCandidate& sector) {
        return is_feasible(sector, options.limits);
    };
    for_each_narrow_sector(fan, [&](const SectorCandidate& sector) {
        const double area = sector.area();
        if (!least.wants(area) && !feasible.wants(area))
            return;
        const SetupScore score{area, sector.polar + sector.opposite_polar + sector.width};
        least.offer(sector, score);
        if (is_allowed(sector))
            feasible.offer(sector, score);
    });
    // One of the two tilts is that of the direction farthest from the pole, so that this
    // is a lower bound of the area.
    const double bound = pi * fan.largest_polar();
    if (setup_rules(options.mode).has_wide_sectors &&
        (least.wants(bound) || feasible.wants(bound))) {
        const std::vector<WideSectors> wide = least_wide_sectors(fan);
        offer_wide_sectors(
            fan, wide, [](const SectorCandidate&) { return true; }, least);
        offer_wide_sectors(fan, wide, is_allowed, feasible);
    }

    PoseSearchResult result;
    result.poses_tried = 1;
    if (const std::optional<SectorCandidate> best = least.best())
        result.least = fitted_pose(points.frame, *best, options.limits);
    if (const std::optional<SectorCandidate> best = feasible.best())
        result.feasible = fitted_pose(points.frame, *best, options.limits);
    if (const std::optional<FittedPose>& shown =
            result.feasible ? result.feasible : result.least)
        result.status = status_of(*shown);
    return result;
}

}  // namespace endmill
