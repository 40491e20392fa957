// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_toolpath.h"

#include <algorithm>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "build_facts.h"
#include "cli/console.h"
#include "cli/path_options.h"
#include "cli/progress.h"
#include "cli/setup_machine.h"
#include "cli/setup_summary.h"
#include "cli/shown_numbers.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"
#include "endmill/setup/path_setup.h"

namespace endmill {
namespace {

SearchedMachine machine_for_path(const SetupCommandOptions& options)
{
    const std::vector<SearchedMachine> machines = setup_machines(options);
    const MachineConfiguration& configuration = machines.front().machine.configuration;
    if (machines.size() > 1 || !configuration.family)
        throw DomainError{
            "--path: expected one machine with two rotary axes that tilt the tool"};
    return machines.front();
}

// What is read for the search.
struct PathInput {
    std::string name;  // of the part
    ToolPath path;
    PathSetupOptions options;
};

PathInput read_input(const SetupCommandOptions& options)
{
    PathOptions reading;
    reading.file = options.toolpath;
    // --clamp belongs to the setup that is searched for, not to a program that is read.
    CommonOptions common = options.common;
    common.given.erase("--clamp");
    std::optional<Tool> tool;
    if (!options.tool.empty())
        tool = read_tool(options.tool, options.common.limits);
    const PathSummary beside = path_summary_of(reading, common);
    std::optional<Cutter> cutter = tool ? std::optional{tool->cutter} : beside.cutter;
    Program program = read_program_for(reading, cutter, common, beside.machine);
    if (!cutter)
        cutter = program.cutter;
    PathInput input{printable(beside.name.value_or(
                        std::filesystem::path{options.toolpath}.stem().string())),
                    std::move(program.path),
                    {.clamp = options.clamp}};
    input.options.tool_length = tool ? tool->length : 0;
    if (cutter)
        input.options.cutter = *cutter;
    return input;
}

Json rows_of(const Eigen::Matrix3d& matrix)
{
    Json rows = Json::array();
    for (int r = 0; r < 3; ++r)
        rows.push_back(vector_json(matrix.row(r)));
    return rows;
}

// The travel of the linear axes, the ranges of the rotary ones, and the slack.
void add_motions(Json& summary, const PathSetup& found, const Machine& machine)
{
    const auto& positions = found.motions.path.machine->positions;
    Json travel = Json::object();
    Json slack = Json::object();
    for (int axis = 0; axis < 3; ++axis) {
        const auto [low, high] = std::ranges::minmax_element(
            positions, {}, [axis](const AxisPositions& at) { return at.xyz[axis]; });
        const std::string letter(1, "xyz"[axis]);
        travel[letter] = {low->xyz[axis], high->xyz[axis]};
        slack[letter] = finite_or_null(found.clamping.slack[axis]);
    }
    Json rotary = Json::object();
    for (std::size_t k = 0; k < machine.configuration.rotary.size(); ++k) {
        const auto [low, high] = std::ranges::minmax_element(
            positions, {}, [k](const AxisPositions& at) { return at.rotary[k]; });
        rotary[std::string(1, machine.configuration.rotary[k].letter)] = {
            Angle::radians(low->rotary[k]).written_degrees(),
            Angle::radians(high->rotary[k]).written_degrees()};
    }
    summary["travel_mm"] = travel;
    summary["slack_mm"] = slack;
    summary["rotary_range_deg"] = rotary;
    summary["rotary_travel_deg"] =
        Angle::radians(found.motions.report.rotary_travel).written_degrees();
}

Json toolpath_summary(const PathInput& input, const SearchedMachine& machine,
                      const PathSetup& found, const SetupCommandOptions& options)
{
    Json summary{{"name", input.name}, {"endmill", program_version}};
    summary.update(machine_json(machine));
    summary.update(Json{{"path", printable(options.toolpath)},
                        {"points", input.path.points.size()},
                        {"axes", found.axes},
                        {"poses_tried", found.poses_tried},
                        {"machinable", true},
                        {"tool_axis", vector_json(found.pose.tool_axis)},
                        {"r1_axis", vector_json(found.pose.r1_axis)},
                        {"r2_axis", vector_json(found.pose.r2_axis)},
                        {"part_to_machine", rows_of(found.part_to_machine)},
                        {"clamp_mm", vector_json(found.clamping.clamp)},
                        {"tool_length_mm", input.options.tool_length}});
    add_motions(summary, found, machine.machine);
    return summary;
}

std::string toolpath_text(const Json& s)
{
    const Json& axis = s["tool_axis"];
    const Json& clamp = s["clamp_mm"];
    std::string text = fmt::format(
        "{}: the whole path is within reach on {}; {}, different tool axes: {}\n",
        s["name"].get<std::string>(), s["configuration"].get<std::string>(),
        counted(s["points"].get<std::size_t>(), "point"), s["axes"].get<std::size_t>());
    text +=
        fmt::format("  tool axis    ({:.4f}, {:.4f}, {:.4f}) of the part; {} tried\n",
                    axis[0].get<double>(), axis[1].get<double>(), axis[2].get<double>(),
                    counted(s["poses_tried"].get<std::size_t>(), "rotation"));
    std::string slack;
    for (const auto& [letter, value] : s["slack_mm"].items())
        if (!value.is_null())
            slack += fmt::format(", {} {}", letter, shown(value.get<double>()));
    text += fmt::format("  clamping     {}, {}, {} mm{}\n",
                        shown_coordinate(clamp[0].get<double>()),
                        shown_coordinate(clamp[1].get<double>()),
                        shown_coordinate(clamp[2].get<double>()),
                        slack.empty() ? "" : "; slack" + slack.substr(1) + " mm");
    std::string ranges;
    for (const auto& [letter, range] : s["rotary_range_deg"].items())
        ranges += fmt::format("{} from {} to {}, ", letter,
                              shown_degrees(range[0].get<double>()),
                              shown_degrees(range[1].get<double>()));
    return text + fmt::format("  rotary axes  {}travel {} degrees\n", ranges,
                              shown_degrees(s["rotary_travel_deg"].get<double>()));
}

PathSetup found_setup(PathInput& input, const Machine& machine,
                      const CommonOptions& common)
{
    ProgressLine progress{"trying rotations of the part", common};
    input.options.progress = [&](std::size_t done, std::size_t all) {
        progress.show(static_cast<double>(done) / static_cast<double>(all));
    };
    return path_setup(input.path, machine, input.options);
}

}  // namespace

ExitCode run_setup_toolpath(const SetupCommandOptions& options)
{
    const SearchedMachine machine = machine_for_path(options);
    PathInput input = read_input(options);
    if (options.tool.empty())
        warn(options.common,
             "the tool length is taken as 0; --tool FILE states the length from the "
             "spindle to the tip");
    OutputFolder folder{output_folder(options.toolpath, "setup", options.common),
                        options.common.full_folder};
    for (const std::string& file : {options.toolpath, options.tool, machine.file})
        if (!file.empty())
            folder.protect(file);
    const Json summary = toolpath_summary(
        input, machine, found_setup(input, machine.machine, options.common), options);
    // Remove results of an earlier run, which may show another pose.
    for (const char* name : {"setup.vtp", "setup.svg", "sphere.svg", "visibility.csv",
                             "visibility.bsm", "cones.csv"})
        folder.remove_unless_written(name);
    folder.write("summary.json", summary.dump(2) + "\n");
    folder.publish();
    print_result(options.common, summary,
                 toolpath_text(summary) + "written to " +
                     printable(folder.path().string()) + "\n");
    return ExitCode::Yes;
}

}  // namespace endmill
