// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_answer.h"

#include <chrono>
#include <utility>

#include <fmt/format.h>

#include "cli/progress.h"
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

RotaryReach reach_of(const Machine& machine, const SetupCommandOptions& options)
{
    return {.configuration = machine.configuration,
            .limits = machine.rotary,
            .arc_tolerance = Angle::degrees(options.arc_tolerance_deg)};
}

// Progress of the search over whole cones, in the unit of its objective.
std::string set_progress_text(const WholeConeSearchProgress& now,
                              SetupObjective objective)
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

PartSetup setup_on(const SetupMachine& machine, const SetupInput& input,
                   const SetupVisibility& visibility, const SetupCommandOptions& options)
{
    ProgressLine progress{"searching for a setup", options.common};
    const double looks = 2 * static_cast<double>(visibility.map().cells());
    return find_setup(
        input.grid, visibility.file.visibility,
        {.reach = reach_of(machine.machine, options),
         .mode = options.mode,
         .objective = options.objective,
         .floor = Angle::degrees(options.floor_deg).radians(),
         .gap = options.gap,
         .max_nodes = static_cast<std::size_t>(options.max_nodes),
         .cell_progress =
             [&](std::size_t done) { progress.show(static_cast<double>(done) / looks); },
         .cone_progress =
             [&](const WholeConeSearchProgress& now) {
                 progress.show(set_progress_text(now, options.objective));
             }});
}

void add_travel(SetupAnswer& answer, const SetupInput& input,
                const SetupVisibility& visibility, const SetupCommandOptions& options)
{
    const Machine& machine = answer.machine->machine;
    const SetupPose& pose = answer.told()->pose;
    answer.part_to_machine = part_to_machine(pose, machine.configuration);
    if (answer.machine->is_family || !answer.best.feasible)
        return;
    const PartVisibility& cones = visibility.file.visibility;
    if (const auto reached = reached_points(input.mesh, cones, input.grid.centres,
                                            pose_frame(machine.configuration, pose),
                                            cell_limits(reach_of(machine, options))))
        answer.travel = setup_travel(machine, *answer.part_to_machine, *reached,
                                     options.clamp, input.tool ? input.tool->length : 0);
    else
        answer.is_out_of_reach = true;
}

SetupCover several_setups(const SetupMachine& machine, const SetupInput& input,
                          const VisibilityMap& map, const SetupCommandOptions& options)
{
    ProgressLine progress{"choosing setups", options.common};
    return greedy_setups(map, input.grid.centres, reach_of(machine.machine, options),
                         static_cast<std::size_t>(options.max_setups),
                         [&](const SetupCoverProgress& now) {
                             progress.show(fmt::format("setup {}, {} of {} tool axes",
                                                       now.setup, now.tried, now.axes));
                         });
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
    return best.machinable == Answer::Yes && is_travel_ok() != false;
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
    if (answer.told())
        add_travel(answer, input, visibility, options);
    if (options.max_setups > 1 && configuration.is_valid())
        answer.setups = several_setups(machine, input, visibility.map(), options);
    answer.seconds = seconds_since(start);
    return answer;
}

std::optional<double> SetupAnswer::floored_area_deg2(double floor_deg) const
{
    return endmill::floored_area_deg2(best, machine->machine.configuration, floor_deg);
}

bool ranks_before(const SetupAnswer& one, const SetupAnswer& other,
                  const SetupCommandOptions& options)
{
    const auto key = [&](const SetupAnswer& answer) {
        return std::pair{setup_rank(answer.best, answer.machine->machine.configuration,
                                    options.floor_deg),
                         answer.machine->file};
    };
    return key(one) < key(other);
}

}  // namespace endmill
