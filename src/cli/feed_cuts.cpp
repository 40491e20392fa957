// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_cuts.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/core/text.h"
#include "endmill/files/result_csv.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/stock/stock_engagement.h"

// Cuts are found, planned and written in blocks, so that the memory for a cut and its loads
// does not grow with the path. With the stock they are kept together, since the stock is
// simulated once for all of them.

namespace endmill {
namespace {

// The cuts of a block are found, planned and formatted by one thread, while another adds
// the blocks before to the result in order. Between batches of blocks all threads wait.
constexpr std::size_t cuts_a_block = 1U << 10U;
constexpr std::size_t blocks_a_batch = 1U << 6U;

HeightStock stock_of(const FeedInput& input, const FeedCommandOptions& options)
{
    if (input.stock.kept)
        return input.stock.kept->heights;
    require_stock_memory(input.stock.block, options.resolution,
                         options.common.limits.max_memory_gib);
    return block_stock(input.stock.block, options.resolution);
}

std::string stock_text(const FeedInput& input)
{
    const auto& [low, high] = input.stock.block;
    return "the stock, x " + to_text(low.x()) + " to " + to_text(high.x()) + ", y " +
           to_text(low.y()) + " to " + to_text(high.y()) + ", z " + to_text(low.z()) +
           " to " + to_text(high.z()) + " mm";
}

void require_meeting(const FeedInput& input, const ToolPath& path,
                     const SegmentCutFinder& finder)
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < finder.size(); ++i)
        points.push_back(finder.point(i));
    const double gap = stock_gap(path, points, input.tool.cutter, input.stock.block);
    if (gap > 0)
        throw GeometryError{"no cutting move meets " + stock_text(input) +
                            ": the cutter stays " + to_text(gap) +
                            " mm away; expected a --stock where the path cuts"};
}

MeasuredFeeds stock_plan(const FeedInput& input, const ToolPath& path,
                         const SegmentCuts& cuts, const FeedCommandOptions& options)
{
    HeightStock stock = stock_of(input, options);
    ProgressLine progress{"removing material and planning feeds", options.common};
    const BallFrontTask task{.path = &path,
                             .cutter = input.tool.cutter,
                             .points = cuts.points,
                             .progress = [&](double share) { progress.show(share); }};
    MeasuredFeeds measured = measured_feed_plan(
        cuts.cuts, input.job, input.plan,
        [&](const FrontVisit& visit) { for_each_ball_front(stock, task, visit); });
    if (!measured.has_engagement)
        throw GeometryError{"no cutting move finds material in " + stock_text(input) +
                            ", though the cutter goes through its box; expected a "
                            "--stock with material where the path cuts"};
    return measured;
}

double number_or_nan(const std::optional<double>& number)
{
    return number.value_or(std::numeric_limits<double>::quiet_NaN());
}

// Consecutive cuts with their plan.
struct PlannedCuts {
    std::span<const SegmentCut> cuts;
    std::span<const std::size_t> points;
    std::span<const SegmentFeed> rows;
};

using Sink = std::function<void(std::string_view piece)>;

// Some consecutive cuts with their feeds and the text of their rows.
struct FedBlock {
    SegmentCuts cuts = {};
    std::vector<SegmentFeed> rows = {};
    std::string text = {};
};

FedBlock fed_block(SegmentCuts cuts, const MillingJob& job, const FeedPlanOptions& plan)
{
    FedBlock block{.cuts = std::move(cuts)};
    block.rows = feed_plan(block.cuts.cuts, job, plan).rows;
    block.text = feed_rows(block.cuts.cuts, block.rows);
    return block;
}

// Adds planned cuts to the result, block by block.
class FedCutsBuilder {
public:
    FedCutsBuilder(FedCuts& result, const FeedRules& rules, std::size_t cuts)
        : result_{result},
          totals_{rules.limits}
    {
        result_.points.reserve(cuts);
        for (std::vector<double>* numbers :
             {&result_.mu, &result_.pick_feed_mm, &result_.horizontal_mm})
            numbers->reserve(cuts);
    }

    // `milling_of` returns the milling of the cut with an index in this block.
    template <typename MillingOf>
    void add(const PlannedCuts& block, const MillingOf& milling_of)
    {
        result_.fed.plan(block.points, block.rows);
        for (std::size_t i = 0; i < block.cuts.size(); ++i) {
            const SegmentCut& cut = block.cuts[i];
            totals_.add(block.rows[i], cut.length_mm);
            result_.points.push_back(static_cast<std::uint32_t>(block.points[i]));
            result_.mu.push_back(number_or_nan(cut.mu));
            result_.pick_feed_mm.push_back(number_or_nan(cut.pick_feed_mm));
            result_.horizontal_mm.push_back(number_or_nan(cut.pick_feed_horizontal_mm));
            result_.between += cut.has_two_neighbours ? 1 : 0;
            if (cut.previous != PreviousPass::None)
                ++(milling_of(i) == Milling::Down ? result_.down : result_.up);
        }
    }

    void add(const FedBlock& block)
    {
        result_.by_contact += block.cuts.by_contact;
        result_.by_passes += block.cuts.by_passes;
        add({block.cuts.cuts, block.cuts.points, block.rows},
            [&](std::size_t i) { return block.cuts.cuts[i].milling; });
    }

    void finish(double plunge_feed_mm_per_min)
    {
        result_.totals = totals_.totals();
        result_.fed.complete(plunge_feed_mm_per_min);
    }

private:
    FedCuts& result_;
    FeedTotalsSum totals_;
};

void plan_by_geometry(FedCutsBuilder& builder, const SegmentCutFinder& finder,
                      const FeedInput& input, const FeedCommandOptions& options,
                      const Sink& sink)
{
    ProgressLine progress{"planning feeds", options.common};
    FeedPlanOptions plan = input.plan;
    std::optional<CoefficientTable> table;
    if (options.coefficients == CoefficientSource::Table)
        plan.table = &table.emplace(plan.chip);
    std::vector<FedBlock> blocks(blocks_a_batch);
    const auto begin = [&](std::size_t block) {
        return std::min(block * cuts_a_block, finder.size());
    };
    const std::size_t count = (finder.size() + cuts_a_block - 1) / cuts_a_block;
    for (std::size_t batch = 0; batch < count; batch += blocks_a_batch)
        parallel_in_order(
            std::min(blocks_a_batch, count - batch),
            [&](std::size_t i) {
                const std::size_t first = begin(batch + i);
                blocks[i] = fed_block(finder.cuts(first, begin(batch + i + 1) - first),
                                      input.job, plan);
            },
            [&](std::size_t i) {
                const FedBlock block = std::exchange(blocks[i], {});
                builder.add(block);
                sink(block.text);
                progress.show(static_cast<double>(begin(batch + i + 1)) /
                              static_cast<double>(finder.size()));
            });
}

}  // namespace

std::unique_ptr<const SegmentCutFinder> cut_finder(const FeedInput& input,
                                                   const ToolPath& path,
                                                   const FeedCommandOptions& options)
{
    SegmentCutOptions cut{.radius = input.job.tool.radius,
                          .stock_top = input.stock_top,
                          .first_pass = options.first_pass,
                          .part = input.part,
                          .contact_tolerance = options.contact_tolerance};
    if (options.engagement == EngagementChoice::Contact)
        cut.source = CutSource::Contact;
    if (options.engagement == EngagementChoice::Passes)
        cut.source = CutSource::Passes;
    auto finder = std::make_unique<const SegmentCutFinder>(path, cut);
    if (finder->size() == 0)
        throw GeometryError{
            "no move of the path cuts; expected a cutting move of some length"};
    if (!finder->has_depth())
        throw GeometryError{"the whole path lies above the stock, whose top is at z = " +
                            to_text(input.stock_top) +
                            " mm; expected a higher --stock-top or --stock"};
    if (options.stock != "block")
        require_meeting(input, path, *finder);
    return finder;
}

void plan_feeds(FedCuts& result, std::unique_ptr<const SegmentCutFinder> finder,
                const FeedInput& input, const FeedCommandOptions& options,
                const Sink& sink)
{
    FedCutsBuilder builder{result, feed_rules(input.job, input.plan), finder->size()};
    result.zero_length = finder->zero_length();
    if (options.engagement == EngagementChoice::Stock) {
        const SegmentCuts cuts = finder->cuts(0, finder->size());
        finder.reset();
        const MeasuredFeeds measured =
            stock_plan(input, result.fed.path(), cuts, options);
        builder.add({cuts.cuts, cuts.points, measured.plan.rows},
                    [&](std::size_t i) { return measured.milling[i]; });
        write_feed_rows(cuts.cuts, measured.plan.rows, sink);
    } else {
        plan_by_geometry(builder, *finder, input, options, sink);
        finder.reset();
    }
    builder.finish(options.plunge_feed_mm_per_min);
}

}  // namespace endmill
