// SPDX-License-Identifier: GPL-3.0-or-later
// endmill feed: feed and spindle speed for each move of a path.

#include <memory>
#include <utility>

#include "cli/console.h"
#include "cli/feed_cuts.h"
#include "cli/feed_files.h"
#include "cli/feed_remarks.h"
#include "cli/progress.h"
#include "cli/view.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/result_csv.h"
#include "endmill/process/fed_path.h"

namespace endmill {
namespace {

constexpr double mm_per_m = 1000;
constexpr double s_per_min = 60;

std::optional<double> planned_minutes(const FedCuts& cuts, const FeedInput& input,
                                      const FeedCommandOptions& options)
{
    if (options.mode != FeedMode::Planned)
        return std::nullopt;
    const double acceleration = input.job.machine.acceleration_m_per_s2.value();
    const std::vector<double> times = planned_times(
        cuts.fed.path(), {mm_per_m * acceleration, options.corner_tolerance});
    double sum = 0;
    for (const std::size_t point : cuts.points)
        sum += times[point];
    return sum / s_per_min;
}

FeedTimes times_of(const FedCuts& cuts, const FeedCommandOptions& options)
{
    std::optional<double> noncut = options.noncut_min;
    if (options.rapid_mm_per_min)
        noncut = cuts.fed.noncut_minutes(*options.rapid_mm_per_min);
    return feed_times({cuts.totals.length_mm, cuts.totals.cut_min, noncut,
                       options.constant_feed_mm_per_min});
}

// Plans the feeds and writes engagement.csv, whose rows are not kept.
void plan_and_write(FedCuts& cuts, std::unique_ptr<const SegmentCutFinder> finder,
                    const FeedInput& input, const FeedCommandOptions& options,
                    OutputFolder& folder)
{
    folder.write_pieces("engagement.csv", [&](const OutputFolder::Sink& sink) {
        write_feed_csv({}, {}, sink);  // the header
        plan_feeds(cuts, std::move(finder), input, options, sink);
    });
}

ExitCode run_feed(const FeedCommandOptions& options)
{
    FeedInput input = read_feed_input(options);
    for (const std::string& remark : input.program.remarks)
        warn(options.common, options.path.file + ": " + remark);
    // There is one path only, which receives the feeds: it may have millions of points.
    FedCuts cuts{.fed = FedPath{std::move(input.program.path)}};
    auto finder = [&] {
        const ProgressLine progress{"finding the engagement", options.common};
        return cut_finder(input, cuts.fed.path(), options);
    }();
    OutputFolder folder{output_folder(options.path.file, "feed", options.common),
                        options.common.full_folder};
    for (const std::string& file : files_of(input, options))
        folder.protect(file);
    plan_and_write(cuts, std::move(finder), input, options, folder);
    std::vector<std::string> remarks = input.program.remarks;
    for (const std::string& remark : feed_remarks(input, cuts)) {
        warn(options.common, options.path.file + ": " + remark);
        remarks.push_back(remark);
    }
    const Json summary = [&] {
        const ProgressLine progress{"writing the results", options.common};
        return write_feed({input, options, cuts, times_of(cuts, options),
                           planned_minutes(cuts, input, options), folder.path(), remarks},
                          folder);
    }();
    folder.remove_unless_written("page.html");
    folder.publish();
    write_html(folder.path(), options.common);
    const bool is_infeasible = cuts.totals.infeasible > 0;
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
