// SPDX-License-Identifier: GPL-3.0-or-later
// endmill post: writes a tool path as a machine program.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/path_tools.h"
#include "cli/post_summary.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/machining_data.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"
#include "endmill/files/read_file.h"
#include "endmill/post/apt.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/post/machine_gcode.h"
#include "endmill/post/machine_path.h"

namespace endmill {
namespace {

// A warning is due if rounding exceeds this share of the tolerance.
constexpr double negligible_share = 0.1;

// Feed of a descent that has none of its own, as a share of the cutting feed.
constexpr double plunge_share = 1.0 / 3;
// s, after the spindle starts: most spindles have their speed by then.
constexpr double default_dwell_s = 2;
// mm, added to the tolerance of the path for arcs: that which `verify` adds.
constexpr double arc_slack_mm = 0.001;
// mm, tolerance of the chords of arcs that were read, if no tolerance of the path is known.
constexpr double default_arc_tolerance_mm = 0.001;

// Options replace the values of the path.
void apply_options(ToolPath& path, const PostOptions& options, const FeedSettings& feeds)
{
    for (PathPoint& point : path.points) {
        CuttingConditions& conditions = point.conditions;
        if (options.spindle_rpm)
            conditions.spindle_rpm = options.spindle_rpm;
        if (options.tool)
            conditions.tool = options.tool;
    }
    set_feeds(path, feeds);
}

// The largest distance of arcs from the path. An arc close to the points of a planned path
// replaces the error of its chords, which has the size of the tolerance; the slack covers
// rounding. If the path has no tolerance, its chords may come from arcs that were read.
double arc_tolerance(const PathSummary& known, const PostOptions& options)
{
    const auto tolerance = known.tolerance_mm();
    if (options.arc_fit_tolerance_mm)
        return *options.arc_fit_tolerance_mm;
    if (tolerance == 0)
        throw DomainError{
            "--arcs: the path may deviate to one side only, and an arc "
            "deviates to both; expected --arc-fit-tolerance, or no --arcs"};
    const double read = options.path.arc_tolerance.value_or(default_arc_tolerance_mm);
    return tolerance.value_or(read) + arc_slack_mm;
}

// Properties of the path. The command line overrides the program, and the program
// overrides the summary beside it.
PathSummary known_of(const Program& program, PathSummary known,
                     const PostOptions& options)
{
    for (const auto& cutter : {program.cutter, options.path.cutter})
        if (cutter)
            known.cutter = cutter;
    if (options.feed_mm_per_min)
        known.feed_mm_per_min = options.feed_mm_per_min;
    if (options.spindle_rpm)
        known.spindle_rpm = options.spindle_rpm;
    return known;
}

// Calls `write`. Its errors are about a point of the path and get the name of the file.
template <typename Write>
WrittenProgram written_path(const PostOptions& options, Write write)
{
    try {
        return write();
    } catch (const DomainError& error) {
        throw DomainError{printable(options.path.file) + ": " + error.what()};
    }
}

// The cutter that is known before the path is read.
std::optional<Cutter> cutter_before(const std::vector<NumberedTool>& table,
                                    const PostOptions& options, const PathSummary& beside)
{
    if (table.size() == 1)
        return table.front().tool.cutter;
    if (!table.empty())
        return std::nullopt;
    return options.path.cutter ? options.path.cutter : beside.cutter;
}

// The format of a G-code program, and what it states beside the path.
GcodeOptions gcode_options(const PostedPath& posted, const Control& control,
                           const PostOptions& options, const FeedSettings& feeds)
{
    const PathSummary& known = posted.known;
    GcodeOptions program;
    program.name = posted.name;
    program.cutter = known.cutter;
    program.feed_mm_per_min = known.feed_mm_per_min;
    program.spindle_rpm = known.spindle_rpm;
    program.tool = options.tool.value_or(program.tool);
    program.safe_height = options.safe_height;
    program.tolerance = known.tolerance_mm().value_or(0);  // unknown: exact path
    program.decimals = options.decimals;
    program.line_numbers = options.line_numbers;
    program.comments = options.comments;
    program.control = control;
    program.unit = options.unit;
    program.coolant = options.coolant;
    program.dwell_s = options.dwell_s.value_or(control.dwell ? default_dwell_s : 0);
    program.feeds = feeds;
    program.approach_distance = options.approach_distance;
    if (options.lead_in == LeadIn::Ramp)
        program.ramp = Angle::degrees(options.ramp_angle_deg);
    if (options.arcs)
        program.arc_tolerance = arc_tolerance(known, options);
    return program;
}

// The largest deviation of a machine with rotary axes from the path.
double motion_tolerance(const PostedPath& posted, const PostOptions& options)
{
    const auto tolerance = posted.known.tolerance_mm();
    const bool is_usable = tolerance && *tolerance > 0;
    return options.machine.tolerance.value_or(is_usable ? *tolerance / 2
                                                        : MachinePathOptions{}.tolerance);
}

// The program for a machine with rotary axes, and what its motions are.
void write_machine_program(PostedPath& posted, const PartOnMachine& setup,
                           const PostOptions& options, const GcodeOptions& format)
{
    const MachinePostOptions& machine = options.machine;
    if (!posted.known.cutter)
        throw DomainError{"--machine: " + printable(options.path.file) +
                          ": the cutter is not known; expected --cutter or --tool"};
    const MachinePathOptions moving{
        .frame = options.path.rotary.frame.value_or(Interpolation::Joint),
        .tolerance = motion_tolerance(posted, options),
        .cutter = *posted.known.cutter,
        .singular = machine.singular,
        .singular_cone = Angle::degrees(machine.singular_cone_deg),
        .retract = machine.retract,
        .free_height = free_height(posted.read.path),
        .rapid_feed = machine.rapid_feed};
    MachinePath made = machine_path(posted.read.path, setup, moving);
    WrittenMachineProgram written =
        machine_gcode(made, format, {machine.angle_decimals, machine.blend});
    posted.written = std::move(written.program);
    made.path.machine->positions.clear();
    posted.motion = PostedMotion{.machine = std::move(*made.path.machine),
                                 .rows = posted.read.path.points.size(),
                                 .tolerance_mm = moving.tolerance,
                                 .report = made.report,
                                 .xyz_range = written.xyz_range,
                                 .rotary_range = written.rotary_range,
                                 .rounding_tip_mm = written.rounding_tip_mm};
}

// Refuses an axis that three axes cannot direct.
void require_machine_for_turns(const Program& program, const PostOptions& options)
{
    for (std::size_t i = 0; i < program.path.points.size(); ++i) {
        const Vec3& axis = program.path.points[i].location.axis;
        if (axis == Vec3::UnitZ())
            continue;
        throw DomainError{printable(options.path.file) + ": the axis at point " +
                          std::to_string(i) + " of the path is " + to_text(axis.x()) +
                          ", " + to_text(axis.y()) + ", " + to_text(axis.z()) +
                          ", and a 3-axis machine cannot turn the tool; expected "
                          "--machine, or the axis 0, 0, 1 throughout"};
    }
}

// Refuses what the written program could not do as the path and the options ask.
void require_writable(const Program& program, const PostOptions& options)
{
    if (const auto point = program.counterclockwise_from)
        throw FormatError{
            "E_GCODE",
            {printable(options.path.file), "",
             "the spindle turns counterclockwise (M4) on the move to point " +
                 std::to_string(*point) + ", and the written program has M3",
             "a program with M3"}};
    if (const auto point = program.tapping_from)
        throw FormatError{
            "E_GCODE",
            {printable(options.path.file), "",
             "a tapping cycle (G74, G84) reverses the spindle on the move to point " +
                 std::to_string(*point) + ", and the written program does not",
             "a program without tapping cycles"}};
    if (!options.safe_height || !options.path.rotary.machine.empty())
        return;
    const auto extent = path_totals(program.path).extent;
    if (extent && *options.safe_height < extent->high.z())
        throw DomainError{"--safe-height: found " + to_text(*options.safe_height) +
                          ", and the path reaches " + to_text(extent->high.z()) +
                          " mm; expected no less"};
}

// Warnings to read before the machine starts.
void warn_of(const PostedPath& posted, const PostOptions& options)
{
    for (const std::string& remark : posted.read.remarks)
        warn(options.common, options.path.file + ": " + remark);
    const auto tolerance = posted.known.tolerance_mm();
    if (const auto remark = rounding_remark(posted.read, tolerance.value_or(HUGE_VAL)))
        warn(options.common, options.path.file + ": " + *remark);
    if (posted.motion && options.machine.tool_file.empty() &&
        options.path.rotary.frame.value_or(Interpolation::Joint) == Interpolation::Joint)
        warn(options.common,
             "the tool length is taken as 0; --tool FILE states the length from the "
             "spindle to the tip");
    const double error = posted.written.max_rounding_error_mm;
    if (tolerance && error > negligible_share * *tolerance)
        warn(options.common,
             fmt::format("coordinates are rounded by up to {} mm, with a tolerance of {} "
                         "mm; use more --decimals",
                         shown_bound(error), shown_limit(*tolerance)));
    if (posted.written.slanted_rapids > 0)
        warn(options.common,
             fmt::format("rapids that change height and position together: {}; not every "
                         "machine moves straight there",
                         posted.written.slanted_rapids));
    if (posted.written.straight_descents > 0)
        warn(options.common,
             fmt::format("descents that stay vertical, because no cut follows them, the "
                         "cuts are too short for a slope, or the tool was changed: {}",
                         posted.written.straight_descents));
    if (options.format == PostFormat::Gcode && !posted.written.spindle_rpm.least)
        warn(options.common,
             "no spindle speed is known: M3 has no S word; expected --spindle-rpm");
}

// Writes the program in the requested language.
PostedPath posted_path(const Program& program, PathSummary known,
                       const PostOptions& options, const FeedSettings& feeds)
{
    const std::string stem = std::filesystem::path{options.path.file}.stem().string();
    PostedPath posted{printable(known.name.value_or(stem)),
                      std::move(known),
                      program,
                      {},
                      stem + ".apt",
                      {},
                      {},
                      {}};
    const ProgressLine progress{"writing the program", options.common};
    if (options.format == PostFormat::Apt) {
        constexpr int apt_decimals = 4;
        const AptOptions format{posted.name,
                                posted.known.cutter,
                                posted.known.feed_mm_per_min,
                                posted.known.spindle_rpm,
                                options.decimals.value_or(apt_decimals),
                                options.multax};
        const Cutter cutter = posted.known.cutter.value_or(MachinePathOptions{}.cutter);
        posted.written = written_path(options, [&] {
            if (!program.path.machine)
                return apt(program.path, format);
            return apt(
                linear_path(program.path, cutter, motion_tolerance(posted, options)),
                format);
        });
        return posted;
    }
    posted.control = chosen_control(options);
    require_possible(options, *posted.control);
    posted.file = stem + posted.control->extension;
    const GcodeOptions format = gcode_options(posted, *posted.control, options, feeds);
    const auto setup =
        part_on_machine(options.path.rotary, options.path.tool_length, options.common);
    if (setup) {
        write_machine_program(posted, *setup, options, format);
        return posted;
    }
    require_machine_for_turns(program, options);
    posted.written = written_path(options, [&] { return gcode(program.path, format); });
    return posted;
}

// Whether the summary.json beside `file` describes exactly this file, as after an earlier
// run of `post`. Any other file belongs to somebody else.
bool is_earlier_program(const std::filesystem::path& file, const ReadLimits& limits)
{
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored))
        return false;
    try {
        const auto summary = read_path_summary(file, limits);
        return summary && summary->toolpath_sha256 &&
               *summary->toolpath_sha256 == content_sha256(read_file(file, limits));
    } catch (const Error&) {
        return false;
    }
}

// The options with what the tool file of --tool states.
PostOptions with_tool_file(PostOptions options)
{
    if (options.machine.tool_file.empty())
        return options;
    const Tool tool = read_tool(options.machine.tool_file, options.common.limits);
    if (options.path.cutter && !(*options.path.cutter == tool.cutter))
        throw DomainError{"--cutter: found " + cutter_word(*options.path.cutter) +
                          ", and the tool file of --tool has " +
                          cutter_word(tool.cutter) + "; expected only one of them"};
    options.path.cutter = tool.cutter;
    options.path.tool_length = tool.length;
    return options;
}

ExitCode run_post(const PostOptions& given)
{
    const PostOptions options = with_tool_file(given);
    refuse_idle_post_options(options);
    require_within_extent("--safe-height", options.safe_height, options.common.limits);
    refuse_idle_tool_options(options.path, options.common);
    const std::vector<NumberedTool> table = read_tools_for(options.path, options.common);
    const PathSummary beside = path_summary_of(options.path, options.common);
    Program program =
        read_program_for(options.path, cutter_before(table, options, beside),
                         options.common, beside.machine);
    require_writable(program, options);
    put_rapids_of_no_tool_to_others(program.path);
    PathSummary known = known_of(program, beside, options);
    std::vector<NumberedTool> tools;
    if (!table.empty()) {
        PathTools used = tools_of_path(program.path, printable(options.path.file),
                                       printable(options.path.tools), table);
        known.cutter = only_cutter(used);
        tools = std::move(used.used);
    }
    const FeedSettings feeds{
        known.feed_mm_per_min,
        options.feed_mm_per_min ? FeedChoice::OfSettings : FeedChoice::OfPath,
        options.plunge_feed_mm_per_min, plunge_share};
    apply_options(program.path, options, feeds);
    PostedPath posted = posted_path(program, std::move(known), options, feeds);
    posted.tools = std::move(tools);
    warn_of(posted, options);

    OutputFolder folder{output_folder(options.path.file, "post", options.common),
                        options.common.full_folder};
    folder.protect(options.path.file);
    if (!options.path.tools.empty())
        folder.protect(options.path.tools);
    Json summary = post_summary(posted, options);
    if (posted.known.part) {
        const auto& [file, units, up] = *posted.known.part;
        name_part(summary, {file.string(), units, up}, folder.path());
    }
    if (posted.known.protected_part) {
        const auto& [file, units, up] = *posted.known.protected_part;
        name_part(summary, {file.string(), units, up}, folder.path(), "protected");
    }
    folder.write(posted.file, posted.written.text);
    folder.write("summary.json", summary.dump(2) + "\n");
    for (const std::string& extension : program_extensions()) {
        const std::string file =
            std::filesystem::path{options.path.file}.stem().string() + extension;
        if (is_earlier_program(folder.path() / file, options.common.limits))
            folder.remove_unless_written(file);
    }
    folder.publish();
    print_result(options.common, summary,
                 post_text(summary, posted, options) + "written to " +
                     printable(folder.path().string()) + "\n");
    return ExitCode::Yes;
}

}  // namespace

void add_post_command(CLI::App& program, Action& action)
{
    CLI::App* command =
        program.add_subcommand("post", "write a tool path as G-code or APT CL data");
    const auto options = std::make_shared<PostOptions>();
    add_post_options(*command, *options);
    command->footer(
        "Writes summary.json and NAME.ngc (--control linuxcnc), NAME.nc (fanuc, grbl) "
        "or\n"
        "NAME.apt (--format apt) to --output (default ./NAME-post; NAME of\n"
        "results/u/toolpath.csv is results-u). Cutter, tolerance and feed default to\n"
        "those of the path, then of the summary.json beside it. Coordinates are tips.\n"
        "The options are in mm and mm/min for --units inch too.\n\n"
        "With --approach-distance no stock may be higher than this distance above the\n"
        "path; otherwise rapids run into it, which verify reports as collisions.\n"
        "Descents without a cut after them (drilling) do not change.\n\n"
        "With --machine the program has rotary words (G93). Results stay within\n"
        "--tolerance of the path; docs/guide/post.md has an example.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:20 --strategy iso -o "
        "saddle\n"
        "  endmill post saddle/u/toolpath.csv --control fanuc --feed 800 --spindle-rpm "
        "6000");
    command->callback([options, &action] {
        action = [options] {
            return naming(options->path.file, [&] { return run_post(*options); });
        };
    });
}

}  // namespace endmill
