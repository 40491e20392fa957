// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/stock-engagement/simulated_cuts.h"

#include <numbers>

#include "endmill/process/detail/front_load.h"
#include "endmill/process/detail/segment_load.h"
#include "endmill/stock/stock_engagement.h"

namespace endmill {
namespace {

constexpr double bottom_z_mm = -30;   // of the block
constexpr double above_stock_mm = 5;  // height of the tip on its return

std::vector<std::size_t> cut_points(const ToolPath& path)
{
    std::vector<std::size_t> points;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        if (path.points[i].move == Move::Cut)
            points.push_back(i);
    return points;
}

}  // namespace

SimulatedCuts simulated_cuts(const OneWayPasses& plan, const MilledPath& milled,
                             double pitch)
{
    HeightStock stock =
        block_stock({{plan.extent.x.low, plan.extent.y.low, bottom_z_mm},
                     {plan.extent.x.high, plan.extent.y.high, plan.stock_top}},
                    pitch);
    const double before = stock_volume(stock);
    const ToolPath path =
        milled_tool_path(milled, plan.radius, plan.stock_top + above_stock_mm);
    SimulatedCuts simulated;
    simulated.fronts.resize(milled.cuts.size());
    const std::vector<std::size_t> points = cut_points(path);
    for_each_ball_front(stock, {&path, Cutter::ball(plan.radius), points},
                        [&](std::size_t number, const BallFront& front) {
                            simulated.fronts[number] = front;
                        });
    simulated.removed_mm3 = before - stock_volume(stock);
    return simulated;
}

FeedPlan simulated_plan(const std::vector<SegmentCut>& cuts,
                        const SimulatedCuts& simulated, const MillingJob& job,
                        const FeedPlanOptions& options)
{
    const FeedRules rules = feed_rules(job, options);
    const auto load_of = [&](std::size_t i) {
        return front_load(cuts[i].length_mm, simulated.fronts[i], job.tool, options,
                          rules);
    };
    return feed_plan(cuts.size(), load_of, rules);
}

NamedCells engagement_cells(const std::vector<SegmentCut>& cuts,
                            const std::vector<CuttingCoefficients>& coefficients,
                            double radius)
{
    double length = 0;
    double i5 = 0;
    double i7 = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        length += cuts[i].length_mm;
        i5 += cuts[i].length_mm * coefficients[i].I5;
        i7 += cuts[i].length_mm * coefficients[i].I7;
    }
    return {{"mean_i5", i5 / length},
            {"mean_i7", i7 / length},
            {"removed_mm3", 2 * std::numbers::pi * radius * radius * i7}};
}

}  // namespace endmill
