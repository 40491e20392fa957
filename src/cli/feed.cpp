// SPDX-License-Identifier: GPL-3.0-or-later
// endmill feed: feed and spindle speed for each move of a path.

#include <memory>

#include "cli/console.h"
#include "cli/feed_cuts.h"
#include "cli/feed_files.h"
#include "cli/feed_remarks.h"
#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/process/fed_path.h"

namespace endmill {
namespace {

constexpr double mm_per_m = 1000;
constexpr double s_per_min = 60;

std::optional<double> planned_minutes(const ToolPath& path, const SegmentCuts& cuts,
                                      const FeedInput& input,
                                      const FeedCommandOptions& options)
{
    if (options.mode != FeedMode::Planned)
        return std::nullopt;
    const double acceleration = input.job.machine.acceleration_m_per_s2.value();
    const std::vector<double> times =
        planned_times(path, {mm_per_m * acceleration, options.corner_tolerance});
    double sum = 0;
    for (const std::size_t point : cuts.points)
        sum += times[point];
    return sum / s_per_min;
}

FeedTimes times_of(const FeedPlan& plan, const ToolPath& path, const SegmentCuts& cuts,
                   const FeedCommandOptions& options)
{
    std::optional<double> noncut = options.noncut_min;
    if (options.rapid_mm_per_min)
        noncut = noncut_minutes(path, cuts.points, *options.rapid_mm_per_min);
    return feed_times({plan.totals.length_mm, plan.totals.cut_min, noncut,
                       options.constant_feed_mm_per_min});
}

ExitCode run_feed(const FeedCommandOptions& options)
{
    const FeedInput input = read_feed_input(options);
    for (const std::string& remark : input.program.remarks)
        warn(options.common, options.path.file + ": " + remark);
    const SegmentCuts cuts = [&] {
        const ProgressLine progress{"finding the engagement", options.common};
        return feed_cuts(input, options);
    }();
    const CutsPlan planned = cuts_plan(input, cuts, options);
    const FeedPlan& plan = planned.feeds;
    std::vector<std::string> remarks = input.program.remarks;
    for (const std::string& remark : feed_remarks(input, cuts, planned)) {
        warn(options.common, options.path.file + ": " + remark);
        remarks.push_back(remark);
    }
    const ToolPath path = fed_path(input.program.path, cuts.points, plan.rows,
                                   options.plunge_feed_mm_per_min);
    OutputFolder folder{output_folder(options.path.file, "feed", options.common),
                        options.common.full_folder};
    for (const std::string& file : files_of(input, options))
        folder.protect(file);
    const Json summary = [&] {
        const ProgressLine progress{"writing the results", options.common};
        return write_feed(
            {input, options, cuts, plan, path, times_of(plan, path, cuts, options),
             planned_minutes(path, cuts, input, options), folder.path(), remarks},
            folder);
    }();
    folder.publish();
    const bool is_infeasible = plan.totals.infeasible > 0;
    // With --allow-infeasible this is a result and no fault.
    const std::string allowed = is_infeasible && options.allow_infeasible
                                    ? "  infeasible    " + infeasible_text(summary) + "\n"
                                    : "";
    print_result(options.common, summary,
                 feed_text(summary) + allowed + "written to " +
                     printable(folder.path().string()) + "\n");
    if (!is_infeasible || options.allow_infeasible)
        return ExitCode::Yes;
    report_error(
        "E_INFEASIBLE",
        options.path.file + ": " + infeasible_text(summary) + ", or --allow-infeasible",
        ExitCode::No, options.common.json_errors);
    return ExitCode::No;
}

}  // namespace

void add_feed_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "feed", "choose feed and spindle speed for each move of a ball-end mill");
    const auto options = std::make_shared<FeedCommandOptions>();
    add_feed_options(*command, *options);
    command->footer(
        "Writes toolpath.csv, engagement.csv (a row for each cutting move), feed.svg "
        "and\n"
        "summary.json to --output (default ./NAME-feed), and NAME-feed.ngc if TOOLPATH "
        "is "
        "a\n"
        "machine program. The tool axis is +z.\n\n"
        "Exit 1: at least one move has no feasible feed; it gets the smallest feed per "
        "tooth.\n"
        "With --allow-infeasible the exit code is 0.\n\n"
        "Example:\n"
        "  endmill plan datasets/surfaces/wavy.json --cutter ball:10 --chord-tolerance "
        "0.05 --scallop 0.3 --order one-way --direction u -o results\n"
        "  endmill feed results/toolpath.csv --material datasets/materials/steel.json "
        "--machine datasets/machines/milling-machine-steel.json "
        "--tool datasets/tools/ball-10-steel-and-aluminium.json --stock-top 6 "
        "--rapid-mm-per-min 5000 --constant-feed-mm-per-min 80 -o results/feed");
    command->callback([options, &action] {
        action = [options] {
            return naming(options->path.file, [&] { return run_feed(*options); });
        };
    });
}

}  // namespace endmill
