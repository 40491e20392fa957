// SPDX-License-Identifier: GPL-3.0-or-later
// endmill post: writes a tool path as a machine program.

#include <array>
#include <memory>
#include <utility>

#include <fmt/format.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/idle_options.h"
#include "cli/post_summary.h"
#include "cli/progress.h"
#include "cli/shown_numbers.h"
#include "cli/surface_facts.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/path_file.h"
#include "endmill/post/apt.h"
#include "endmill/post/gcode_writer.h"

namespace endmill {
namespace {

// A warning is due if rounding exceeds this share of the tolerance.
constexpr double negligible_share = 0.1;

// Options replace the values of the path.
void apply_options(ToolPath& path, const PostOptions& options)
{
    for (PathPoint& point : path.points) {
        CuttingConditions& conditions = point.conditions;
        if (options.feed_mm_per_min)
            conditions.feed_mm_per_min = options.feed_mm_per_min;
        if (options.spindle_rpm)
            conditions.spindle_rpm = options.spindle_rpm;
        if (options.tool)
            conditions.tool = options.tool;
    }
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

// The program in the requested language.
WrittenProgram written(const ToolPath& path, const std::string& name,
                       const PathSummary& known, const PostOptions& options)
{
    if (options.format == PostFormat::Apt)
        return apt(path, {name, known.cutter, known.feed_mm_per_min, known.spindle_rpm,
                          options.decimals});
    return gcode(path,
                 {name, known.cutter, known.feed_mm_per_min, known.spindle_rpm,
                  options.tool.value_or(1), options.safe_height, known.tolerance_mm(),
                  options.decimals, options.line_numbers, options.comments});
}

// Warnings to read before the machine starts.
void warn_of(const PostedPath& posted, const PostOptions& options)
{
    for (const std::string& remark : posted.read.remarks)
        warn(options.common, options.path.file + ": " + remark);
    const auto tolerance = posted.known.tolerance_mm();
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
    if (options.format == PostFormat::Gcode && !posted.written.spindle_rpm.least)
        warn(options.common,
             "no spindle speed is known: M3 has no S word; expected --spindle-rpm");
}

// Refuses options of G-code in another format.
void refuse_idle_post_options(const PostOptions& options)
{
    if (options.format == PostFormat::Gcode)
        return;
    refuse_idle_options(
        options.common,
        std::array{"--safe-height", "--tool-number", "--line-numbers", "--comments"},
        "--format " + names_of(options.format).word, "--format gcode");
}

ExitCode run_post(const PostOptions& options)
{
    refuse_idle_post_options(options);
    require_within_extent("--safe-height", options.safe_height, options.common.limits);
    const PathSummary beside = path_summary_of(options.path, options.common);
    Program program = read_program_for(
        options.path, options.path.cutter ? options.path.cutter : beside.cutter,
        options.common);
    apply_options(program.path, options);
    PathSummary known = known_of(program, beside, options);
    const std::string stem = std::filesystem::path{options.path.file}.stem().string();
    const std::string name = printable(known.name.value_or(stem));
    WrittenProgram text = [&] {
        const ProgressLine progress{"writing the program", options.common};
        return written(program.path, name, known, options);
    }();
    const PostedPath posted{name, std::move(known), program, std::move(text),
                            stem + names_of(options.format).extension};
    warn_of(posted, options);

    OutputFolder folder{output_folder(options.path.file, "post", options.common),
                        options.common.full_folder};
    folder.protect(options.path.file);
    Json summary = post_summary(posted, options);
    if (posted.known.part) {
        const auto& [file, units, up] = *posted.known.part;
        name_part(summary, {file.string(), units, up}, folder.path());
    }
    folder.write(posted.file, posted.written.text);
    folder.write("summary.json", summary.dump(2) + "\n");
    for (const PostFormat format : {PostFormat::Gcode, PostFormat::Apt})
        folder.remove_unless_written(stem + names_of(format).extension);
    folder.publish();
    print_result(
        options.common, summary,
        post_text(summary) + "written to " + printable(folder.path().string()) + "\n");
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
        "Writes NAME.ngc or NAME.apt and summary.json to --output (default ./NAME-post;\n"
        "NAME of results/u/toolpath.csv is results-u). Cutter, tolerance and feed "
        "default\n"
        "to those of the path, then of the summary.json beside it. Coordinates are tips "
        "in\n"
        "mm.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/saddle.json --cutter ball:20 -o saddle\n"
        "  endmill post saddle/u/toolpath.csv --format gcode --feed 800 --spindle-rpm "
        "6000");
    command->callback([options, &action] {
        action = [options] {
            return naming(options->path.file, [&] { return run_post(*options); });
        };
    });
}

}  // namespace endmill
