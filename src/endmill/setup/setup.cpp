// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup.h"

#include <limits>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/many_cones_search.h"
#include "endmill/setup/detail/sampled_poses.h"
#include "endmill/setup/detail/setup_order.h"
#include "endmill/setup/pose_search.h"

namespace endmill {
namespace {

PoseSearchResult best_at_cells(const SphereGrid& grid, const VisibilityMap& map,
                               const SetupRequest& request, SetupMode mode)
{
    return pose_search(map, grid.centres,
                       {.family = request.reach.configuration.family.value(),
                        .mode = mode,
                        .limits = request.reach.limits,
                        .order = rotary_order(request.reach.configuration),
                        .nearest_cells = request.nearest_cells,
                        .progress = request.cell_progress});
}

// The poses that are tried in turn where travel bounds the search. The search over whole
// cones has no list of poses; its place is taken by that of `Corrected`.
PoseSampling sampling_of(const SetupRequest& request)
{
    if (request.mode != SetupMode::WholeCones)
        return {request.reach, request.mode, {}, request.nearest_cells};
    return {request.reach, SetupMode::Corrected,
            PoseMeasure{family_of(request.reach.configuration),
                        request.whole_cones.objective, request.whole_cones.floor_rad},
            request.nearest_cells};
}

// The objective of the request, of a pose: rad^2, or rad.
double objective_of(const FittedPose& pose, const SetupRequest& request)
{
    return objective_of(pose, sampling_of(request));
}

PartSetup setup_of(PoseSearchResult search)
{
    PartSetup setup;
    // Without any pose, no direction set lay in an open hemisphere: nothing was decided.
    if (search.feasible || search.least)
        setup.machinable = answer_of(search.feasible.has_value());
    setup.is_proved = search.feasible.has_value();
    setup.status = search.status;
    setup.poses_tried = search.poses_tried;
    setup.poses_skipped = search.poses_skipped;
    setup.feasible = std::move(search.feasible);
    setup.least = std::move(search.least);
    if (setup.shown())
        setup.objective = setup.shown()->area;
    return setup;
}

// Words that begin with B have R2 = R1 x C, the search over whole cones has R2 = C x R1.
// Both limits and ranges of theta change from one convention to the other by their mirror
// image.
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
    const PoseSearchResult corrected =
        best_at_cells(grid, map, request, SetupMode::Corrected);
    std::vector<SetupPose> poses;
    for (const std::optional<FittedPose>& fit : {corrected.least, corrected.feasible})
        if (fit)
            poses.push_back(fit->pose);
    return poses;
}

// Two searches: without limits for the least pose, within the limits for the feasible
// one.
PartSetup best_over_whole_cones(const SphereGrid& grid, const VisibilityMap& map,
                                const SetupRequest& request)
{
    const bool is_reversed =
        rotary_order(request.reach.configuration) == RotaryOrder::BFirst;
    const std::vector<SetupPose> starts = starting_poses(grid, map, request);
    WholeConeSearchOptions options{.family = request.reach.configuration.family.value(),
                                   .objective = request.whole_cones.objective,
                                   .floor_rad = request.whole_cones.floor_rad,
                                   .gap = request.whole_cones.gap,
                                   .max_nodes = request.whole_cones.max_nodes,
                                   .limits = {},
                                   .starts = starts,
                                   .progress = request.whole_cones.progress};
    const WholeConeSearchResult any = many_cones_search(grid, map, options);
    const RotaryLimits& limits = request.reach.limits;
    const bool is_limited = limits != RotaryLimits{};
    if (is_limited)
        options.limits = is_reversed ? with_r2_reversed(limits) : limits;
    const WholeConeSearchResult found =
        is_limited ? many_cones_search(grid, map, options) : any;

    PartSetup setup;
    setup.machinable = found.machinable;
    setup.is_proved = found.machinable != Answer::Undecided;
    setup.feasible = found.pose;
    setup.least = any.pose;
    const WholeConeSearchResult& shown = found.pose ? found : any;
    setup.certificate = SetupCertificate{shown.lower_bound, found.unresolved};
    setup.poses_tried = found.nodes + (is_limited ? any.nodes : 0);
    for (std::optional<FittedPose>* fit : {&setup.feasible, &setup.least})
        if (*fit && is_reversed)
            *fit = with_r2_reversed(**fit);
    if (shown.pose) {
        setup.objective = shown.objective;
        setup.status = status_of(*shown.pose);
    }
    return setup;
}

PartSetup four_axis_setup(const SphereGrid& grid, const VisibilityMap& map,
                          const SetupRequest& request)
{
    PartSetup setup =
        setup_of(arc_search(map, grid.centres, four_axis_axes(), request.reach.limits.phi,
                            request.reach.arc_tolerance));
    if (!setup.feasible)
        setup.machinable = Answer::No;
    setup.objective = std::nullopt;
    if (setup.least)
        setup.objective = objective_of(*setup.least, request);
    return setup;
}

// Trying every cell decides what a machine of three axes can do.
PartSetup three_axis_setup(const SphereGrid& grid, const PartVisibility& visibility,
                           const SetupRequest& request)
{
    const VisibilityMap& map = visibility.map;
    const DirectionReach widest = widest_direction(map);
    const bool reaches_all = widest.facets == map.facets() - visibility.dropped.size();
    PartSetup setup;
    setup.status = SetupStatus::ThreeAxis;
    setup.machinable = answer_of(reaches_all);
    setup.is_proved = true;
    setup.poses_tried = map.cells();
    if (!reaches_all)
        return setup;
    setup.feasible = pose_without_rotary_axes(grid, widest.cell);
    setup.least = setup.feasible;
    setup.objective = objective_of(*setup.least, request);
    return setup;
}

// A configuration that is not valid machines nothing.
PartSetup no_setup()
{
    PartSetup setup;
    setup.machinable = Answer::No;
    setup.is_proved = true;
    return setup;
}

PartSetup setup_for_reachable_facets(const SphereGrid& grid,
                                     const PartVisibility& visibility,
                                     const SetupRequest& request)
{
    const MachineConfiguration& configuration = request.reach.configuration;
    if (!configuration.is_valid())
        return no_setup();
    if (configuration.family)
        return five_axis_setup(grid, visibility.map, request);
    if (configuration.rotary.empty())
        return three_axis_setup(grid, visibility, request);
    return four_axis_setup(grid, visibility.map, request);
}

// Examines the linear axes at the feasible pose of `setup` and its clamping position.
void add_travel(MachineSetup& setup, const PartWithCones& part,
                const RotaryLimits& limits, double tool_length)
{
    const Machine& machine = setup.machine;
    const std::optional<ReachedPoints> reached = reached_points(
        part.mesh, part.visibility, part.grid.centres,
        pose_frame(machine.configuration, setup.best.feasible->pose), limits);
    if (reached)
        setup.travel = setup_travel(machine, *setup.part_to_machine, *reached,
                                    setup.clamp, tool_length);
    setup.within_travel = answer_of(setup.travel && setup.travel->is_within);
}

// Replaces the feasible pose of `setup` by the best one within the linear limits.
void search_within_travel(MachineSetup& setup, const PartWithCones& part,
                          const SetupRequest& request, const Clamping& clamping)
{
    const ClampingSearch search{part.mesh,
                                part.visibility,
                                part.grid.centres,
                                setup.machine,
                                reach_limits(request.reach),
                                clamping.tool_length};
    std::vector<FittedPose> poses{*setup.best.feasible};
    TravelSearch found = travel_search(search, poses, clamping.origin);
    if (!found.fits()) {
        for (const FittedPose& pose :
             sampled_poses(part.grid, part.visibility, sampling_of(request)))
            if (!is_same_pose(pose.pose, poses.front().pose))
                poses.push_back(pose);
        found = travel_search(search, poses, clamping.origin);
    }
    setup.travel_search = found;
    if (!found.fits())
        return;
    setup.best.feasible = found.pose;
    setup.best.objective = objective_of(*found.pose, request);
    setup.best.status = status_of(*found.pose);
    setup.clamp = found.clamping->clamp;
}

}  // namespace

PartSetup find_setup(const SphereGrid& grid, const PartVisibility& visibility,
                     const SetupRequest& request)
{
    PartSetup setup = setup_for_reachable_facets(grid, visibility, request);
    if (empty_cones(visibility).empty())
        return setup;
    // No setup reaches every facet. The least pose describes what the other facets need.
    setup.machinable = Answer::No;
    setup.is_proved = true;
    setup.feasible = std::nullopt;
    setup.certificate = std::nullopt;
    setup.objective = std::nullopt;
    if (setup.least)
        setup.objective = objective_of(*setup.least, request);
    return setup;
}

PartSetup five_axis_setup(const SphereGrid& grid, const VisibilityMap& map,
                          const SetupRequest& request)
{
    require(request.reach.configuration.family.has_value(),
            "five_axis_setup: need a machine with two rotary axes that tilt the tool");
    // Facets with equal cones need the same directions: one of them is searched for.
    if (request.mode == SetupMode::WholeCones) {
        const VisibilityMap cones = DistinctCones{map}.map();
        return best_over_whole_cones(grid, cones, request);
    }
    return setup_of(
        best_at_cells(grid, map_of_distinct_cones(map), request, request.mode));
}

std::optional<double> floored_area_deg2(const PartSetup& setup,
                                        const MachineConfiguration& configuration,
                                        double floor_deg)
{
    if (!setup.shown())
        return std::nullopt;
    const PoseRanges ranges = pose_ranges(family_of(configuration), *setup.shown());
    return (Angle::radians(ranges.width).degrees() + floor_deg) *
           (Angle::radians(ranges.height()).degrees() + floor_deg);
}

std::partial_ordering operator<=>(const SetupRank& a, const SetupRank& b)
{
    const auto key = [](const SetupRank& rank) {
        const int place = rank.machinable == Answer::Yes         ? 0
                          : rank.machinable == Answer::Undecided ? 1
                                                                 : 2;
        return std::tuple{place, rank.area_deg2, std::string_view{rank.word}};
    };
    return key(a) <=> key(b);
}

SetupRank setup_rank(const PartSetup& setup, const MachineConfiguration& configuration,
                     double floor_deg)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {setup.machinable,
            floored_area_deg2(setup, configuration, floor_deg).value_or(infinity),
            configuration.word};
}

bool MachineSetup::is_machinable() const
{
    return best.machinable == Answer::Yes &&
           !(has_linear_limits() && within_travel == Answer::No);
}

MachineSetup machine_setup(const PartWithCones& part, const Machine& machine,
                           SetupRequest request, const std::optional<Clamping>& clamping)
{
    request.reach.configuration = machine.configuration;
    request.reach.limits = machine.rotary;
    MachineSetup setup{.machine = machine,
                       .best = find_setup(part.grid, part.visibility, request)};
    if (clamping)
        setup.clamp = clamping->origin.value_or(Vec3::Zero());
    const bool has_travel = setup.best.feasible && clamping;
    const bool is_bounded = has_travel && setup.has_linear_limits() &&
                            clamping->travel == TravelRule::WithinLimits;
    if (is_bounded)
        search_within_travel(setup, part, request, *clamping);
    if (setup.best.shown())
        setup.part_to_machine =
            part_to_machine(setup.best.shown()->pose, machine.configuration);
    if (has_travel)
        add_travel(setup, part, reach_limits(request.reach), clamping->tool_length);
    if (setup.travel_search)
        setup.within_travel = answer_of(setup.travel_search->fits());
    return setup;
}

std::optional<double> floored_area_deg2(const MachineSetup& setup, double floor_deg)
{
    return floored_area_deg2(setup.best, setup.machine.configuration, floor_deg);
}

SetupRank setup_rank(const MachineSetup& setup, double floor_deg)
{
    SetupRank rank = setup_rank(setup.best, setup.machine.configuration, floor_deg);
    if (setup.travel_search && !setup.travel_search->fits())
        rank.machinable = Answer::No;
    return rank;
}

}  // namespace endmill
