// SPDX-License-Identifier: GPL-3.0-or-later
// Speed of a whole feed plan, from the text of a path to the texts of all results, with
// the bars.
//
//   benchmarks-feed OUTPUT_FOLDER
//
// About two minutes; measures time, so nothing else should run. Columns: README.md beside this.

#include <array>
#include <functional>

#include "benchmarks/simulation/low_saddle.h"
#include "endmill/core/parallel.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/fed_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"
#include "endmill/stock/stock_engagement.h"
#include "support/experiment.h"
#include "support/shortest_times.h"

using namespace endmill;

namespace {

constexpr double radius_mm = 5;
constexpr double stock_top_mm = 20;
constexpr double plunge_feed_mm_per_min = 200;
constexpr FeedAcceleration motion{1000, 0.01};

// The calibrated steel and its tool: datasets/materials, datasets/tools.
const MillingJob job{{2000.5566, 0.016, 0.4, 0.4, 0.2, 0.6, 0.3680141, 28.4313},
                     {.radius = radius_mm,
                      .flutes = 2,
                      .helix = 0.5235987755982988,
                      .cutting_force_n = 1258.193195,
                      .thrust_n = 452.9691635,
                      .torque_n_m = 19.6133}};

FeedPlanOptions plan_options(PeakRule peak)
{
    FeedPlanOptions options;
    options.peak = peak;
    options.max_feed_per_tooth_mm = 0.15;
    return options;
}

SegmentCuts cuts_of(const ToolPath& path)
{
    return segment_cuts(path, {.radius = radius_mm, .stock_top = stock_top_mm});
}

// Number of bytes that `feed` writes, its texts made in parallel as there.
std::size_t written(const ToolPath& fed, const SegmentCuts& cuts, const FeedPlan& plan)
{
    const auto limits = limit_words(fed.points.size(), cuts.points, plan.rows);
    const std::array<std::function<std::string()>, 3> texts{
        [&] { return feed_svg(cuts.cuts, plan.rows, {}); },
        [&] { return tool_path_csv(fed, limits); },
        [&] { return feed_csv(cuts.cuts, plan.rows); }};
    std::array<std::size_t, 3> bytes{};
    parallel_for(texts.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            bytes[i] = texts[i]().size();
    });
    return bytes[0] + bytes[1] + bytes[2];
}

// The work of `endmill feed` on the text of a path.
std::size_t whole(const std::string& text, int threads)
{
    set_thread_count(threads);
    const ToolPath path = parse_tool_path(text, "path.csv").path;
    const SegmentCuts cuts = cuts_of(path);
    const FeedPlan plan = feed_plan(cuts.cuts, job, plan_options(PeakRule::Constant));
    return written(fed_path(path, cuts.points, plan.rows, plunge_feed_mm_per_min), cuts,
                   plan);
}

// A plan with the engagement of the simulated stock.
double stock_plan(const ToolPath& path, const SegmentCuts& cuts, PeakRule peak,
                  int threads)
{
    set_thread_count(threads);
    const FeedPlanOptions options = plan_options(peak);
    const FeedRules rules = feed_rules(job, options);
    Block block = LowSaddle::block();
    block.high.z() = stock_top_mm;
    HeightStock stock = block_stock(block, 0.1);
    std::vector<SegmentFeed> rows(cuts.cuts.size());
    for_each_ball_front(
        stock, {&path, Cutter::ball(radius_mm), cuts.points},
        [&](std::size_t i, const BallFront& front) {
            rows[i] = segment_feed(
                front_load(cuts.cuts[i].length_mm, front, job.tool, options, rules),
                rules);
        });
    return rows.back().table.feed_mm_per_min;
}

// Measures every part of the work separately, on one thread.
void add_parts(const std::string& text)
{
    set_thread_count(1);
    static const ToolPath path = parse_tool_path(text, "path.csv").path;
    static const SegmentCuts cuts = cuts_of(path);
    static const FeedPlan plan =
        feed_plan(cuts.cuts, job, plan_options(PeakRule::Constant));
    static const ToolPath fed =
        fed_path(path, cuts.points, plan.rows, plunge_feed_mm_per_min);
    static const CoefficientTable table;
    add_benchmark("read", [&text] {
        set_thread_count(1);
        return parse_tool_path(text, "path.csv").path.points.size();
    });
    add_benchmark("geometry", [] { return cuts_of(path).cuts.size(); });
    add_benchmark("feeds", [] {
        return feed_plan(cuts.cuts, job, plan_options(PeakRule::Constant)).totals.cut_min;
    });
    add_benchmark("feeds by the table", [] {
        FeedPlanOptions options = plan_options(PeakRule::Constant);
        options.table = &table;
        return feed_plan(cuts.cuts, job, options).totals.cut_min;
    });
    add_benchmark("motion", [] { return planned_times(fed, motion).size(); });
    add_benchmark("write", [] { return written(fed, cuts, plan); });
}

void add_turning(const std::string& name, PeakRule peak, const ToolPath& path)
{
    add_benchmark(name, [=] {
        set_thread_count(1);
        const SegmentCuts cuts = cuts_of(path);
        return feed_plan(cuts.cuts, job, plan_options(peak)).totals.cut_min;
    });
}

void add_stock(const std::string& name, PeakRule peak, const ToolPath& path)
{
    const SegmentCuts cuts = cuts_of(path);
    add_benchmark(name + ", one", [=] { return stock_plan(path, cuts, peak, 1); });
    add_benchmark(name + ", two", [=] { return stock_plan(path, cuts, peak, 2); });
}

}  // namespace

int main(int argc, char** argv)
{
    return run_experiment(argc, argv, "benchmarks/feed", [](Experiment& run) {
        const int steps = static_cast<int>(run.number("steps"));
        const int lines = static_cast<int>(run.number("lines"));
        const int few_lines = static_cast<int>(run.number("few_lines"));
        const Cutter ball = Cutter::ball(radius_mm);
        const std::string many = tool_path_csv(saddle_path(ball, lines, steps));
        const std::string tenth = tool_path_csv(saddle_path(ball, lines / 10, steps));
        const ToolPath few = saddle_path(ball, few_lines, steps);
        const SegmentCuts few_cuts = cuts_of(few);
        add_benchmark("whole, one", [&] { return whole(many, 1); });
        add_benchmark("whole, two", [&] { return whole(many, 2); });
        add_benchmark("tenth, one", [&] { return whole(tenth, 1); });
        add_parts(many);
        add_turning("torque", PeakRule::Torque, few);
        add_turning("direct", PeakRule::Direct, few);
        add_stock("stock", PeakRule::Constant, few);
        add_stock("stock, direct", PeakRule::Direct, few);
        const ShortestTimes times = shortest_times();

        CsvTable result{{"row", "measured", "unit", "bar_at_most", "bar_at_least"}};
        const auto wall = [&](const char* name) { return times.of(name).wall_s; };
        result.add_row({"whole, two threads", wall("whole, two"), "s", 1, {}});
        result.add_row({"whole, one thread", wall("whole, one"), "s", {}, {}});
        result.add_row({"one over two threads",
                        wall("whole, one") / wall("whole, two"),
                        "1",
                        {},
                        1.8});
        result.add_row({"100 over 10 thousand segments",
                        wall("whole, one") / wall("tenth, one"),
                        "1",
                        12,
                        {}});
        for (const char* part :
             {"read", "geometry", "feeds", "feeds by the table", "motion", "write"})
            result.add_row({part, times.of(part).cpu_s, "s", {}, {}});
        const double ms_a_segment = 1000 / static_cast<double>(few_cuts.cuts.size());
        for (const char* peak : {"torque", "direct"})
            result.add_row(
                {peak, ms_a_segment * times.of(peak).cpu_s, "ms a segment", 1, {}});
        for (const std::string stock : {"stock", "stock, direct"}) {
            const double one = times.of(stock + ", one").wall_s;
            result.add_row({stock, ms_a_segment * one, "ms a segment", {}, {}});
            result.add_row({stock + ", one over two threads",
                            one / times.of(stock + ", two").wall_s,
                            "1",
                            {},
                            {}});
        }
        run.write_result(result);
    });
}
