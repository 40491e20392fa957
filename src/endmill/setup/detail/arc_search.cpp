// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/arc_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/least_cones.h"
#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();

// The interval of azimuths of directions on the circle within the tolerance of a cell.
struct NearCell {
    double from;  // rad, from 0 to 2 pi
    double to;    // rad, at least `from`
    std::size_t cell;
};

// Lists the cells close to the circle, sorted by the begins of their intervals. A cell at
// the latitude b is within the tolerance t of the azimuths that differ from its own by at
// most delta, where cos t = cos b cos delta.
std::vector<NearCell> cells_near(const PolePoints& points, double tolerance)
{
    std::vector<NearCell> near;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (std::abs(points.z[i]) > std::sin(tolerance))
            continue;
        const double rho = std::hypot(points.x[i], points.y[i]);
        const double delta = std::acos(std::min(std::cos(tolerance) / rho, 1.0));
        const double from = full_turn(points.azimuth(i) - delta);
        near.push_back({from, from + 2 * delta, i});
    }
    std::sort(near.begin(), near.end(), [](const NearCell& a, const NearCell& b) {
        return a.from != b.from ? a.from < b.from : a.cell < b.cell;
    });
    return near;
}

// Calls `take` with the number of each set bit.
template <class Take>
void for_each_bit(std::span<const std::uint64_t> words, const Take& take)
{
    for (std::size_t i = 0; i < words.size(); ++i) {
        for (std::uint64_t word = words[i]; word != 0; word &= word - 1)
            take(i * 64 + static_cast<std::size_t>(std::countr_zero(word)));
    }
}

// A map of the minimal cones: an arc that meets these meets all cones.
VisibilityMap minimal_cones(const VisibilityMap& map)
{
    const DistinctCones cones{map};
    return cones.map(least_cones(cones));
}

// Tests whether each facet has a cell among these. If not, no window is wide enough.
bool reach_all(const VisibilityMap& map, const std::vector<NearCell>& near)
{
    std::vector<std::uint64_t> reached(map.words(), 0);
    for (const NearCell& cell : near) {
        const auto column = map.column(cell.cell);
        for (std::size_t i = 0; i < reached.size(); ++i)
            reached[i] |= column[i];
    }
    std::size_t facets = 0;
    for (const std::uint64_t word : reached)
        facets += static_cast<std::size_t>(std::popcount(word));
    return facets == map.facets();
}

struct Window {
    double begin;  // rad
    double width;  // rad
};

// Finds the least window that meets an interval of a cell of each facet.
//
// A least window ends at the begin of an interval. For each facet it must begin before
// the end of an interval that has begun so far; the interval with the last end is the
// best. So the window begins at the least of these ends over all facets. Two rounds about
// the axis consider all windows.
std::optional<Window> least_window(const VisibilityMap& map,
                                   const std::vector<NearCell>& near)
{
    if (!reach_all(map, near))
        return std::nullopt;
    std::vector<double> ends(map.facets(), -infinity);
    Window least{0, infinity};
    for (const double round : {0.0, 2 * pi}) {
        for (const NearCell& cell : near) {
            for_each_bit(map.column(cell.cell), [&](std::size_t facet) {
                ends[facet] = std::max(ends[facet], cell.to + round);
            });
            double begin = cell.from + round;
            for (const double end : ends)
                begin = std::min(begin, end);
            const double width = cell.from + round - begin;
            if (width < least.width - equal_angles)
                least = {begin, width};
        }
    }
    if (least.width == infinity)
        return std::nullopt;
    return least;
}

void check_arc(const VisibilityMap& map, std::span<const Vec3> centres, Angle tolerance)
{
    require(centres.size() == map.cells(), "arc search: need a centre for each cell");
    require(0 <= tolerance.radians() && tolerance.radians() <= pi / 4,
            "arc search: need a tolerance of 0 to 45 degrees");
}

std::optional<DirectionArc> arc_about(const VisibilityMap& map,
                                      std::span<const Vec3> centres, const Vec3& axis,
                                      double tolerance)
{
    const PolePoints points{axis, centres};
    const auto near = cells_near(points, std::max(tolerance, equal_angles));
    const std::optional<Window> window = least_window(map, near);
    if (!window)
        return std::nullopt;
    return DirectionArc{axis, points.frame.equator(window->begin),
                        window->width > 2 * equal_angles ? window->width : 0};
}

// The shortest arc about each axis, where there is one.
std::vector<std::optional<DirectionArc>> arcs_about(const VisibilityMap& map,
                                                    std::span<const Vec3> centres,
                                                    std::span<const Vec3> axes,
                                                    Angle tolerance)
{
    const VisibilityMap cones = minimal_cones(map);
    std::vector<std::optional<DirectionArc>> arcs(axes.size());
    parallel_for(axes.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            arcs[i] = arc_about(cones, centres, axes[i], tolerance.radians());
    });
    return arcs;
}

bool fits(const DirectionArc& arc, const RotaryRange& limits)
{
    return arc.length <= limits.to - limits.from + equal_angles;
}

FittedPose fitted_pose(const DirectionArc& arc, const RotaryRange& limits)
{
    const double room = limits.to - limits.from;
    const double before = room > 0 ? arc.length * limits.from / room : 0;
    const Vec3 tool_axis =
        std::cos(before) * arc.begin - std::sin(before) * arc.axis.cross(arc.begin);
    FittedPose fit;
    fit.pose = {tool_axis, arc.axis, tool_axis.cross(arc.axis)};
    fit.phi = {before, before + arc.length};
    fit.theta = {0, 0};
    fit.area = 0;
    return fit;
}

}  // namespace

std::optional<DirectionArc> shortest_arc(const VisibilityMap& map,
                                         std::span<const Vec3> centres, const Vec3& axis,
                                         Angle tolerance)
{
    check_arc(map, centres, tolerance);
    return arc_about(minimal_cones(map), centres, axis, tolerance.radians());
}

PoseSearchResult arc_search(const VisibilityMap& map, std::span<const Vec3> centres,
                            std::span<const Vec3> axes, const RotaryRange& limits,
                            Angle tolerance)
{
    check_arc(map, centres, tolerance);
    check_pose_fit_options({.limits = {limits, {}}});
    PoseSearchResult result;
    result.poses_tried = axes.size();
    BestCandidate<DirectionArc> best;
    for (const std::optional<DirectionArc>& arc :
         arcs_about(map, centres, axes, tolerance)) {
        if (arc)
            best.offer(*arc, {0, arc->length});
        else
            ++result.poses_skipped;
    }
    if (const std::optional<DirectionArc> shortest = best.best()) {
        result.least = fitted_pose(*shortest, limits);
        result.status = status_of(*result.least);
        if (fits(*shortest, limits))
            result.feasible = result.least;
    }
    return result;
}

std::vector<FittedPose> arcs_within_limits(const VisibilityMap& map,
                                           std::span<const Vec3> centres,
                                           std::span<const Vec3> axes,
                                           const RotaryRange& limits, Angle tolerance)
{
    check_arc(map, centres, tolerance);
    check_pose_fit_options({.limits = {limits, {}}});
    std::vector<FittedPose> poses;
    for (const auto& arc : arcs_about(map, centres, axes, tolerance))
        if (arc && fits(*arc, limits))
            poses.push_back(fitted_pose(*arc, limits));
    return poses;
}

DirectionReach widest_direction(const VisibilityMap& map)
{
    require(map.cells() > 0, "widest_direction: need a cell");
    DirectionReach widest;
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        std::size_t facets = 0;
        for (const std::uint64_t word : map.column(cell))
            facets += static_cast<std::size_t>(std::popcount(word));
        if (facets > widest.facets)
            widest = {cell, facets};
    }
    return widest;
}

}  // namespace endmill
