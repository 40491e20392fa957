// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/feed_cuts.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/progress.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/stock/stock_engagement.h"

namespace endmill {
namespace {

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

void require_meeting(const FeedInput& input, const SegmentCuts& cuts)
{
    const double gap =
        stock_gap(input.program.path, cuts.points, input.tool.cutter, input.stock.block);
    if (gap > 0)
        throw GeometryError{"no cutting move meets " + stock_text(input) +
                            ": the cutter stays " + to_text(gap) +
                            " mm away; expected a --stock where the path cuts"};
}

CutsPlan stock_plan(const FeedInput& input, const SegmentCuts& cuts,
                    const FeedCommandOptions& options)
{
    HeightStock stock = stock_of(input, options);
    ProgressLine progress{"removing material and planning feeds", options.common};
    const BallFrontTask task{.path = &input.program.path,
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
    return {std::move(measured.plan), std::move(measured.milling)};
}

}  // namespace

SegmentCuts feed_cuts(const FeedInput& input, const FeedCommandOptions& options)
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
    SegmentCuts cuts = segment_cuts(input.program.path, cut);
    if (cuts.cuts.empty())
        throw GeometryError{
            "no move of the path cuts; expected a cutting move of some length"};
    const auto is_deep = [](const SegmentCut& move) { return move.depth_mm > 0; };
    if (std::ranges::none_of(cuts.cuts, is_deep))
        throw GeometryError{"the whole path lies above the stock, whose top is at z = " +
                            to_text(input.stock_top) +
                            " mm; expected a higher --stock-top or --stock"};
    if (options.stock != "block")
        require_meeting(input, cuts);
    return cuts;
}

CutsPlan cuts_plan(const FeedInput& input, const SegmentCuts& cuts,
                   const FeedCommandOptions& options)
{
    if (options.engagement == EngagementChoice::Stock)
        return stock_plan(input, cuts, options);
    const ProgressLine progress{"planning feeds", options.common};
    FeedPlanOptions plan = input.plan;
    std::optional<CoefficientTable> table;
    if (options.coefficients == CoefficientSource::Table)
        plan.table = &table.emplace(plan.chip);
    std::vector<Milling> milling;
    for (const SegmentCut& cut : cuts.cuts)
        milling.push_back(cut.milling);
    return {feed_plan(cuts.cuts, input.job, plan), std::move(milling)};
}

}  // namespace endmill
