// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/best_setup.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/many_cones_search.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/pose_search.h"

namespace endmill {
namespace {

SetupSearch at_cells(const SphereGrid& grid, const VisibilityMap& map,
                     const SetupRequest& request, SetupMode mode)
{
    return setup_search(map, grid.centres,
                        {request.family, mode, request.limits, request.is_b_first,
                         request.cell_progress});
}

BestSetup found_at_cells(SetupSearch search)
{
    BestSetup best;
    const bool is_known =
        search.feasible || search.least;  // else no pose could be judged
    if (is_known)
        best.is_machinable = search.feasible.has_value();
    best.is_proved = search.feasible.has_value();
    best.status = search.status;
    best.poses_tried = search.poses_tried;
    best.poses_skipped = search.poses_skipped;
    if (search.feasible || search.least)
        best.objective = (search.feasible ? search.feasible : search.least)->area;
    best.feasible = std::move(search.feasible);
    best.least = std::move(search.least);
    return best;
}

// Words that begin with B have R2 = R1 x C, which reverses its turns. Swapping an axis of
// limits with its mirror image takes one convention to the other.
RotaryLimits with_r2_reversed(RotaryLimits limits)
{
    limits.theta = turned(limits.theta);
    return limits;
}

FittedPose with_r2_reversed(FittedPose fit)
{
    fit.pose.r2_axis = -fit.pose.r2_axis;
    fit.theta = turned(fit.theta);
    return fit;
}

std::vector<SetupPose> starting_poses(const SphereGrid& grid, const VisibilityMap& map,
                                      const SetupRequest& request)
{
    const SetupSearch corrected = at_cells(grid, map, request, SetupMode::Corrected);
    std::vector<SetupPose> poses;
    for (const std::optional<FittedPose>& fit : {corrected.least, corrected.feasible})
        if (fit)
            poses.push_back(fit->pose);
    return poses;
}

BestSetup over_cones(const SphereGrid& grid, const VisibilityMap& map,
                     const SetupRequest& request)
{
    const bool is_reversed = request.family == RotaryFamily::AB && request.is_b_first;
    const std::vector<SetupPose> starts = starting_poses(grid, map, request);
    SetSearchOptions options{request.family, request.objective,   request.floor,
                             request.gap,    request.max_nodes,   {},
                             starts,         request.set_progress};
    const SetSearchResult any = many_cones_search(grid, map, options);
    const bool is_limited = request.limits != RotaryLimits{};
    if (is_limited)
        options.limits = is_reversed ? with_r2_reversed(request.limits) : request.limits;
    SetSearchResult found = is_limited ? many_cones_search(grid, map, options) : any;

    BestSetup best;
    if (found.machinability != Machinability::Undecided)
        best.is_machinable = found.machinability == Machinability::Machinable;
    best.is_proved = best.is_machinable.has_value();
    best.feasible = found.pose;
    best.least = any.pose;
    const SetSearchResult& told = found.pose ? found : any;
    best.objective = told.objective;
    best.lower_bound = told.lower_bound;
    best.unresolved = found.unresolved;
    best.poses_tried = found.nodes + (is_limited ? any.nodes : 0);
    for (std::optional<FittedPose>* fit : {&best.feasible, &best.least})
        if (*fit && is_reversed)
            *fit = with_r2_reversed(**fit);
    if (told.pose)
        best.status = status_of(*told.pose);
    return best;
}

}  // namespace

PoseRanges pose_ranges(RotaryFamily family, const FittedPose& fit)
{
    const bool is_ca = family == RotaryFamily::CA;
    const RotaryRange& window = is_ca ? fit.theta : fit.phi;
    const RotaryRange& other = is_ca ? fit.phi : fit.theta;
    return {window.to - window.from, other.to, -other.from};
}

std::array<double, 2> magnitudes(const RotaryRange& range)
{
    const double one = std::abs(range.from);
    const double other = std::abs(range.to);
    return {std::min(one, other), std::max(one, other)};
}

BestSetup best_setup(const SphereGrid& grid, const VisibilityMap& map,
                     const SetupRequest& request)
{
    // Facets that are seen alike ask for the same directions: of flat regions one is left.
    const VisibilityMap cones = DistinctCones{map}.map();
    if (!request.mode)
        return over_cones(grid, cones, request);
    return found_at_cells(at_cells(grid, cones, request, *request.mode));
}

}  // namespace endmill
