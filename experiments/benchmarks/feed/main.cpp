// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of a whole feed plan, from the text of a path to the texts of all results, with
// the bars.
//
//   benchmarks-feed OUTPUT_FOLDER
//
// About three minutes; measures time, so nothing else should run. Columns: README.md beside
// this.

#include "benchmarks/feed/feed_table.h"
#include "benchmarks/feed/feed_work.h"
#include "benchmarks/height_parts.h"
#include "endmill/core/parallel.h"
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/path_file.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/fed_path.h"
#include "support/experiment.h"

using namespace endmill;

namespace {

constexpr FeedAcceleration motion{1000, 0.01};

// Measures every part of the work separately, on one thread.
void add_parts(const std::string& text)
{
    set_thread_count(1);
    static const ToolPath path = parse_tool_path(text, "path.csv").path;
    static const SegmentCuts cuts = cuts_along(path);
    static const FeedPlan plan = plan_feeds(cuts, feed_options(PeakRule::Constant));
    static const ToolPath fed = path_with_feeds(path, cuts, plan);
    static const CoefficientTable table;
    add_benchmark("read", [&text] {
        set_thread_count(1);
        return parse_tool_path(text, "path.csv").path.points.size();
    });
    add_benchmark("geometry", [] { return cuts_along(path).cuts.size(); });
    add_benchmark("feeds", [] {
        return plan_feeds(cuts, feed_options(PeakRule::Constant)).totals.cut_min;
    });
    add_benchmark("feeds by the table", [] {
        FeedPlanOptions options = feed_options(PeakRule::Constant);
        options.table = &table;
        return plan_feeds(cuts, options).totals.cut_min;
    });
    add_benchmark("motion", [] { return planned_times(fed, motion).size(); });
    add_benchmark("write", [] { return written_bytes(fed, cuts, plan); });
}

// Plans with the largest load over the turn, on one thread.
void add_turning(const std::string& name, PeakRule peak, const ToolPath& path)
{
    add_benchmark(name, [=] {
        set_thread_count(1);
        return plan_feeds(cuts_along(path), feed_options(peak)).totals.cut_min;
    });
}

void add_stock(const std::string& name, PeakRule peak, const ToolPath& path)
{
    const SegmentCuts cuts = cuts_along(path);
    add_benchmark(name + ", one", [=] { return stock_feed(path, cuts, peak, 1); });
    add_benchmark(name + ", two", [=] { return stock_feed(path, cuts, peak, 2); });
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/feed", [](Experiment& run) {
        const int steps = static_cast<int>(run.number("steps"));
        const int lines = static_cast<int>(run.number("lines"));
        const int few_lines = static_cast<int>(run.number("few_lines"));
        const Cutter ball = Cutter::ball(feed_radius_mm);
        const std::string many = tool_path_csv(saddle_path(ball, lines, steps));
        const std::string tenth = tool_path_csv(saddle_path(ball, lines / 10, steps));
        const ToolPath few = saddle_path(ball, few_lines, steps);
        const ToolPath dense =
            saddle_path(ball, static_cast<int>(run.number("program_lines")), steps);
        const std::string program = program_along(dense);
        add_benchmark("program, one", [&] { return program_feed(program, 1); });
        add_benchmark("program, two", [&] { return program_feed(program, 2); });
        add_benchmark("whole, one", [&] { return whole_feed(many, 1); });
        add_benchmark("whole, two", [&] { return whole_feed(many, 2); });
        add_benchmark("tenth, one", [&] { return whole_feed(tenth, 1); });
        add_parts(many);
        add_turning("torque", PeakRule::Torque, few);
        add_turning("direct", PeakRule::Direct, few);
        add_stock("stock", PeakRule::Constant, few);
        add_stock("stock, direct", PeakRule::Direct, few);
        run.write_result(feed_table(shortest_times(), cuts_along(few).cuts.size(),
                                    cuts_along(dense).cuts.size()));
    });
}
