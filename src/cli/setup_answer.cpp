// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_answer.h"

#include <chrono>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>
#include <Eigen/Geometry>

#include "cli/progress.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/setup/arc_search.h"
#include "endmill/visibility/visibility.h"

namespace endmill {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

PartVisibility computed(const SetupInput& input, const StoredVisibility& file,
                        const CommonOptions& options)
{
    ProgressLine progress{"casting rays", options};
    const auto cells = static_cast<double>(input.grid.centres.size());
    VisibilityOptions visibility;
    visibility.incidence = file.incidence;
    visibility.kind = file.kind;
    visibility.progress = [&](std::size_t done) {
        progress.show(static_cast<double>(done) / cells);
    };
    PartVisibility found = part_visibility(input.mesh, input.grid.centres, visibility);
    if (!file.tool.empty()) {
        progress.begin("clearing shank and holder");
        keep_reachable(
            found, input.mesh, input.grid.centres, tool_body(*input.tool),
            [&](std::size_t done) { progress.show(static_cast<double>(done) / cells); });
    }
    return found;
}

BestSetup without_setup()
{
    BestSetup best;
    best.is_machinable = false;
    best.is_proved = true;
    return best;
}

SetupRequest request_for(const SetupMachine& machine, const SetupCommandOptions& options)
{
    const MachineConfiguration& configuration = machine.machine.configuration;
    return {.family = configuration.family.value(),
            .is_b_first = configuration.rotary[0].letter == 'b',
            .mode = cell_mode(options.mode),
            .limits = machine.machine.rotary,
            .objective = options.objective,
            .floor = Angle::degrees(options.floor_deg).radians(),
            .gap = options.gap,
            .max_nodes = static_cast<std::size_t>(options.max_nodes)};
}

// What the mode minimises, of a pose: rad^2, or rad.
double objective_of(const FittedPose& pose, const SetupMachine& machine,
                    const SetupCommandOptions& options)
{
    if (options.mode != SetupChoice::Set)
        return pose.area;
    // The one rotary axis of four is phi, as R1 of A,B.
    const RotaryFamily family =
        machine.machine.configuration.family.value_or(RotaryFamily::AB);
    return PoseMeasure{
        family, options.objective,
        Angle::degrees(options.floor_deg).radians()}(pose_ranges(family, pose));
}

// How far the search over whole cones is, in the unit of what it minimises.
std::string set_progress_text(const SetSearchProgress& now, SetupObjective objective)
{
    const bool is_area = objective == SetupObjective::FlooredArea;
    const auto shown = [&](double value) {
        const double in_deg = Angle::radians(value).degrees();
        return is_area ? Angle::radians(in_deg).degrees() : in_deg;
    };
    std::string text = fmt::format("{} nodes, bound {:.6g} {}", now.nodes,
                                   shown(now.lower_bound), is_area ? "deg^2" : "deg");
    if (now.objective)
        text += fmt::format(", best {:.6g}", shown(*now.objective));
    if (now.objective && now.lower_bound > 0)
        text +=
            fmt::format(", gap {:.1f} %", 100 * (*now.objective / now.lower_bound - 1));
    return text;
}

BestSetup five_axis_setup(const SetupMachine& machine, const SetupInput& input,
                          const VisibilityMap& map, const SetupCommandOptions& options)
{
    ProgressLine progress{"searching for a setup", options.common};
    const double looks = 2 * static_cast<double>(map.cells());
    SetupRequest request = request_for(machine, options);
    request.cell_progress = [&](std::size_t done) {
        progress.show(static_cast<double>(done) / looks);
    };
    request.set_progress = [&](const SetSearchProgress& now) {
        progress.show(set_progress_text(now, options.objective));
    };
    return best_setup(input.grid, map, request);
}

// Rotary axes of a machine of four axes that are tried: 2.7 degrees from the next, as half a
// cell of 1200 lets them.
constexpr const char* axes_grid = "ico:4";

BestSetup four_axis_setup(const SetupMachine& machine, const SetupInput& input,
                          const VisibilityMap& map, const SetupCommandOptions& options)
{
    const ProgressLine progress{"searching for a setup", options.common};
    const SetupSearch search =
        arc_search(map, input.grid.centres, sphere_grid(axes_grid).centres,
                   machine.machine.rotary.phi, Angle::degrees(options.arc_tolerance_deg));
    BestSetup best;
    best.is_machinable = search.feasible.has_value();
    best.is_proved = search.feasible.has_value();
    best.status = search.status;
    best.feasible = search.feasible;
    best.least = search.least;
    best.poses_tried = search.poses_tried;
    best.poses_skipped = search.poses_skipped;
    if (search.least)
        best.objective = objective_of(*search.least, machine, options);
    return best;
}

// Some facet is reached from nowhere, so that no setup will do: what is told is the least that
// the others need.
BestSetup of_the_other_facets(BestSetup best, const SetupMachine& machine,
                              const SetupCommandOptions& options)
{
    best.is_machinable = false;
    best.is_proved = true;
    best.feasible = std::nullopt;
    best.lower_bound = std::nullopt;
    best.objective = std::nullopt;
    if (best.least)
        best.objective = objective_of(*best.least, machine, options);
    return best;
}

// All that a machine of three axes can do is decided by trying every direction.
BestSetup three_axis_setup(const SetupMachine& machine, const SetupInput& input,
                           const SetupVisibility& visibility,
                           const SetupCommandOptions& options)
{
    const VisibilityMap& map = visibility.map();
    const DirectionReach widest = widest_direction(map);
    const std::size_t wanted = map.facets() - visibility.file.visibility.dropped.size();
    BestSetup best;
    best.status = SetupStatus::ThreeAxis;
    best.is_machinable = widest.facets == wanted;
    best.is_proved = true;
    best.poses_tried = map.cells();
    if (widest.facets != wanted)
        return best;
    const Vec3 axis = input.grid.centres[widest.cell];
    const Vec3 across = axis.unitOrthogonal();
    best.feasible =
        FittedPose{{axis, across, axis.cross(across)}, {0, 0}, {0, 0}, 0, widest.cell};
    best.least = best.feasible;
    best.objective = objective_of(*best.least, machine, options);
    return best;
}

BestSetup setup_on(const SetupMachine& machine, const SetupInput& input,
                   const SetupVisibility& visibility, const SetupCommandOptions& options)
{
    const MachineConfiguration& configuration = machine.machine.configuration;
    if (!configuration.is_valid())
        return without_setup();
    if (configuration.family)
        return five_axis_setup(machine, input, visibility.map(), options);
    if (configuration.rotary.empty())
        return three_axis_setup(machine, input, visibility, options);
    return four_axis_setup(machine, input, visibility.map(), options);
}

// Of the facets that the pose reaches; none if it does not reach one that some direction does.
std::optional<ReachedPoints> reached_points(const SetupInput& input,
                                            const SetupVisibility& visibility,
                                            const RotaryFrame& frame,
                                            const RotaryLimits& limits)
{
    const auto reaches = facet_reach(visibility.map(), input.grid.centres, frame, limits);
    ReachedPoints reached;
    std::size_t unreached = visibility.file.visibility.dropped.size();
    for (std::size_t j = 0; j < reaches.size(); ++j) {
        if (!reaches[j])
            continue;
        const auto [a, b, c] = input.mesh.corners(j);
        reached.points.push_back((a + b + c) / 3);
        reached.angles.push_back(reaches[j]->angles);
    }
    if (reached.points.empty() || reached.points.size() + unreached < reaches.size())
        return std::nullopt;
    return reached;
}

// The limits within which cells are reached; those of four axes by their tolerance, those of
// three all along one direction.
RotaryLimits reach_limits(const Machine& machine, const SetupCommandOptions& options)
{
    RotaryLimits limits = machine.rotary;
    if (!machine.configuration.family) {
        const double tolerance = Angle::degrees(options.arc_tolerance_deg).radians();
        const double aside = machine.configuration.rotary.empty() ? 0 : tolerance;
        limits.theta = {-aside, aside};
    }
    return limits;
}

void add_travel(SetupAnswer& answer, const SetupInput& input,
                const SetupVisibility& visibility, const SetupCommandOptions& options)
{
    const Machine& machine = answer.machine->machine;
    const SetupPose& pose = answer.told()->pose;
    answer.part_to_machine = part_to_machine(pose, machine.configuration);
    if (answer.machine->is_family || !answer.best.feasible)
        return;
    const RotaryFrame frame{machine.configuration.family.value_or(RotaryFamily::AB),
                            pose.tool_axis, pose.r1_axis, pose.r2_axis};
    if (const auto reached =
            reached_points(input, visibility, frame, reach_limits(machine, options)))
        answer.travel = setup_travel(machine, *answer.part_to_machine, *reached,
                                     options.clamp, input.tool ? input.tool->length : 0);
    else
        answer.is_out_of_reach = true;
}

SetupReach reach_of(const SetupMachine& machine, const SetupCommandOptions& options)
{
    const MachineConfiguration& configuration = machine.machine.configuration;
    const bool has_family = configuration.family.has_value();
    return {configuration.axes(), configuration.family.value_or(RotaryFamily::AB),
            has_family && configuration.rotary[0].letter == 'b', machine.machine.rotary,
            Angle::degrees(options.arc_tolerance_deg)};
}

SetupCover several_setups(const SetupMachine& machine, const SetupInput& input,
                          const VisibilityMap& map, const SetupCommandOptions& options)
{
    ProgressLine progress{"choosing setups", options.common};
    return greedy_setups(map, input.grid.centres, reach_of(machine, options),
                         static_cast<std::size_t>(options.max_setups),
                         [&](const SetupsProgress& now) {
                             progress.show(fmt::format("setup {}, {} of {} tool axes",
                                                       now.setup, now.tried, now.axes));
                         });
}

// Machinable first, then undecided, then not. Travel does not count: it is another wherever
// the part is clamped.
int machinable_rank(const SetupAnswer& answer)
{
    const std::optional<bool> is_machinable = answer.best.is_machinable;
    return is_machinable == true ? 0 : is_machinable == false ? 2 : 1;
}

double ranked_area(const SetupAnswer& answer, const SetupCommandOptions& options)
{
    return answer.floored_area_deg2(options.floor_deg)
        .value_or(std::numeric_limits<double>::infinity());
}

}  // namespace

std::optional<bool> SetupAnswer::is_travel_ok() const
{
    if (machine->machine.linear == LinearLimits{} || (!travel && !is_out_of_reach))
        return std::nullopt;
    return travel && travel->is_within;
}

bool SetupAnswer::is_yes() const
{
    return best.is_machinable == true && is_travel_ok() != false;
}

SetupVisibility visibility_for(const SetupInput& input,
                               const SetupCommandOptions& options)
{
    const Clock::time_point start = Clock::now();
    SetupVisibility found;
    if (input.known_visibility) {
        found.file = *input.known_visibility;
    } else {
        found.file.grid = input.grid.name;
        found.file.incidence = Angle::degrees(options.incidence_deg);
        found.file.part_checksum = part_checksum(input.mesh);
        found.file.kind = options.visibility;
        found.file.tool = body_text(input.tool);
        found.file.visibility = computed(input, found.file, options.common);
    }
    found.empty = empty_cones(found.file.visibility);
    found.seconds = seconds_since(start);
    return found;
}

SetupAnswer answer_for(const SetupMachine& machine, const SetupInput& input,
                       const SetupVisibility& visibility,
                       const SetupCommandOptions& options)
{
    const Clock::time_point start = Clock::now();
    const MachineConfiguration& configuration = machine.machine.configuration;
    SetupAnswer answer{.machine = &machine,
                       .best = setup_on(machine, input, visibility, options)};
    if (!visibility.empty.empty())
        answer.best = of_the_other_facets(answer.best, machine, options);
    if (answer.told())
        add_travel(answer, input, visibility, options);
    if (options.max_setups > 1 && configuration.is_valid())
        answer.setups = several_setups(machine, input, visibility.map(), options);
    answer.seconds = seconds_since(start);
    return answer;
}

std::optional<double> SetupAnswer::floored_area_deg2(double floor_deg) const
{
    if (!told())
        return std::nullopt;
    // The one rotary axis of four is phi, as R1 of A,B.
    const RotaryFamily family =
        machine->machine.configuration.family.value_or(RotaryFamily::AB);
    const PoseRanges ranges = pose_ranges(family, *told());
    return (Angle::radians(ranges.width).degrees() + floor_deg) *
           (Angle::radians(ranges.height()).degrees() + floor_deg);
}

bool ranks_before(const SetupAnswer& one, const SetupAnswer& other,
                  const SetupCommandOptions& options)
{
    const auto key = [&](const SetupAnswer& answer) {
        return std::tuple{machinable_rank(answer), ranked_area(answer, options),
                          answer.machine->machine.configuration.word,
                          answer.machine->file};
    };
    return key(one) < key(other);
}

}  // namespace endmill
