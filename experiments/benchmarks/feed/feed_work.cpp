// SPDX-License-Identifier: GPL-3.0-or-later
#include "benchmarks/feed/feed_work.h"

#include <algorithm>
#include <array>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "benchmarks/height_parts.h"
#include "endmill/core/parallel.h"
#include "endmill/figures/feed_svg.h"
#include "endmill/files/detail/tool_path_reader.h"
#include "endmill/files/path_file.h"
#include "endmill/files/result_csv.h"
#include "endmill/post/fed_gcode.h"
#include "endmill/post/gcode_reader.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/process/fed_path.h"
#include "endmill/stock/stock_engagement.h"

namespace endmill {
namespace {

constexpr double stock_top_mm = 20;
constexpr double plunge_feed_mm_per_min = 200;

// The calibrated steel and its tool: datasets/materials, datasets/tools.
const MillingJob job{{2000.5566, 0.016, 0.4, 0.4, 0.2, 0.6, 0.3680141, 28.4313},
                     {.radius = feed_radius_mm,
                      .flutes = 2,
                      .helix = 0.5235987755982988,
                      .limits = {.cutting_force_n = 1258.193195,
                                 .thrust_n = 452.9691635,
                                 .torque_n_m = 19.6133}}};

constexpr std::size_t cuts_a_block = 1024;
const std::string program_file = "long.ngc";

// Some consecutive cuts with their feeds, and the text of their rows.
struct FedBlock {
    SegmentCuts cuts;
    FeedPlan plan;
    std::string text;
};

// Plans all feeds of a path. Returns the number of bytes of the rows of the cuts.
std::size_t planned_in_blocks(FedPath& fed)
{
    const SegmentCutFinder finder{fed.path(),
                                  {.radius = feed_radius_mm, .stock_top = stock_top_mm}};
    const std::size_t count = (finder.size() + cuts_a_block - 1) / cuts_a_block;
    std::vector<FedBlock> blocks(count);
    std::size_t bytes = 0;
    parallel_in_order(
        count,
        [&](std::size_t i) {
            const std::size_t first = i * cuts_a_block;
            FedBlock& block = blocks[i];
            block.cuts =
                finder.cuts(first, std::min(cuts_a_block, finder.size() - first));
            block.plan = plan_feeds(block.cuts, feed_options(PeakRule::Constant));
            write_feed_rows(block.cuts.cuts, block.plan.rows,
                            [&](std::string_view piece) { block.text += piece; });
        },
        [&](std::size_t i) {
            const FedBlock block = std::exchange(blocks[i], {});
            fed.plan(block.cuts.points, block.plan.rows);
            bytes += block.text.size();
        });
    fed.complete(plunge_feed_mm_per_min);
    return bytes;
}

}  // namespace

FeedPlanOptions feed_options(PeakRule peak)
{
    FeedPlanOptions options;
    options.peak = peak;
    options.max_feed_per_tooth_mm = 0.15;
    return options;
}

SegmentCuts cuts_along(const ToolPath& path)
{
    return segment_cuts(path, {.radius = feed_radius_mm, .stock_top = stock_top_mm});
}

FeedPlan plan_feeds(const SegmentCuts& cuts, const FeedPlanOptions& options)
{
    return feed_plan(cuts.cuts, job, options);
}

ToolPath path_with_feeds(const ToolPath& path, const SegmentCuts& cuts,
                         const FeedPlan& plan)
{
    return fed_path(path, cuts.points, plan.rows, plunge_feed_mm_per_min);
}

std::size_t written_bytes(const ToolPath& fed, const SegmentCuts& cuts,
                          const FeedPlan& plan)
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

std::size_t whole_feed(const std::string& text, int threads)
{
    set_thread_count(threads);
    const ToolPath path = parse_tool_path(text, "path.csv").path;
    const SegmentCuts cuts = cuts_along(path);
    const FeedPlan plan = plan_feeds(cuts, feed_options(PeakRule::Constant));
    return written_bytes(path_with_feeds(path, cuts, plan), cuts, plan);
}

std::string program_along(ToolPath path)
{
    for (PathPoint& point : path.points)
        point.conditions = {.feed_mm_per_min = 800, .spindle_rpm = 6000};
    return gcode(path).text;
}

std::size_t program_feed(const std::string& program, int threads)
{
    set_thread_count(threads);
    const GcodeReadOptions reading;
    FedPath fed{parse_gcode(program, program_file, reading).path};
    std::array<std::size_t, 3> bytes{planned_in_blocks(fed)};
    const std::array<std::function<void()>, 2> works{
        [&] {
            write_tool_path_csv(
                fed.path(), [&](std::size_t i) { return fed.limit_word(i); },
                [&](std::string_view piece) { bytes[1] += piece.size(); });
        },
        [&] {
            write_fed_gcode(program, program_file, reading, fed.path(),
                            [&](std::string_view piece) { bytes[2] += piece.size(); });
        }};
    parallel_for(works.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            works[i]();
    });
    return bytes[0] + bytes[1] + bytes[2];
}

double stock_feed(const ToolPath& path, const SegmentCuts& cuts, PeakRule peak,
                  int threads)
{
    set_thread_count(threads);
    Block block = LowSaddle::block();
    block.high.z() = stock_top_mm;
    HeightStock stock = block_stock(block, 0.1);
    const auto measure = [&](const FrontVisit& visit) {
        for_each_ball_front(stock, {&path, Cutter::ball(feed_radius_mm), cuts.points},
                            visit);
    };
    return measured_feed_plan(cuts.cuts, job, feed_options(peak), measure)
        .plan.rows.back()
        .table.feed_mm_per_min;
}

}  // namespace endmill
