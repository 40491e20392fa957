// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <algorithm>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/segment_load.h"

namespace endmill {
namespace {

// Relative: above the 1e-5 to which a load's largest value over a turn is known, so that a
// limit as told does admit the least feed.
constexpr double needed_margin = 2e-5;

// `needed` or what `load` needs where it is above `limit`.
void raise(std::optional<double>& needed, double load, const std::optional<double>& limit)
{
    if (limit && load > *limit)
        needed = std::max(needed.value_or(0), (1 + needed_margin) * load);
}

void add(FeedPlanTotals& totals, const SegmentFeed& row, double length)
{
    totals.length_mm += length;
    totals.cut_min += length / row.table.feed_mm_per_min;
    totals.limit_shares[static_cast<std::size_t>(said_limit(row))] += length;
    totals.speed_limit_shares[static_cast<std::size_t>(row.table.speed_limit)] += length;
    totals.max_torque_n_m = std::max(totals.max_torque_n_m, row.loads.torque_n_m);
    totals.max_power_w = std::max(totals.max_power_w, row.table.power_w);
}

// Of every move; by the table if there is one.
std::vector<CuttingCoefficients> all_coefficients(std::span<const SegmentCut> cuts,
                                                  double radius,
                                                  const FeedPlanOptions& options)
{
    std::vector<BallEngagement> engagements;
    engagements.reserve(cuts.size());
    for (const SegmentCut& cut : cuts)
        engagements.push_back(ball_engagement(cut, radius));
    if (options.table == nullptr)
        return cutting_coefficients(engagements, options.chip, options.accuracy);
    std::vector<CuttingCoefficients> all(engagements.size());
    parallel_for(all.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            all[i] = options.table->coefficients(engagements[i]);
    });
    return all;
}

}  // namespace

FeedPlanTotals feed_plan_totals(const std::vector<SegmentFeed>& rows,
                                const std::vector<double>& lengths_mm,
                                const LoadLimits& limits)
{
    require(rows.size() == lengths_mm.size(), "feed_plan_totals: need a length a row");
    FeedPlanTotals totals;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        add(totals, rows[i], lengths_mm[i]);
        if (!rows[i].tooth.is_infeasible)
            continue;
        ++totals.infeasible;
        raise(totals.needed.cutting_force_n, rows[i].loads.cutting_force_n,
              limits.cutting_force_n);
        raise(totals.needed.thrust_n, rows[i].loads.thrust_n, limits.thrust_n);
        raise(totals.needed.torque_n_m, rows[i].loads.torque_n_m, limits.torque_n_m);
    }
    if (totals.length_mm > 0) {
        for (double& share : totals.limit_shares)
            share /= totals.length_mm;
        for (double& share : totals.speed_limit_shares)
            share /= totals.length_mm;
    }
    return totals;
}

FeedPlan feed_plan(std::size_t count,
                   const std::function<SegmentLoad(std::size_t)>& load_of,
                   const FeedRules& rules)
{
    require_sound(rules);
    FeedPlan plan;
    plan.rows.resize(count);
    std::vector<double> lengths(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const SegmentLoad load = load_of(i);
            lengths[i] = load.length_mm;
            plan.rows[i] = segment_feed(load, rules);
        }
    });
    plan.totals = feed_plan_totals(plan.rows, lengths, rules.limits);
    return plan;
}

FeedPlan feed_plan(std::span<const SegmentCut> cuts, const MillingJob& job,
                   const FeedPlanOptions& options)
{
    const FeedRules rules = feed_rules(job, options);
    if (options.peak != PeakRule::Constant)
        return feed_plan(
            cuts.size(),
            [&](std::size_t i) {
                return turning_load(cuts[i], job.tool, options.peak, options.chip, rules);
            },
            rules);
    const std::vector<CuttingCoefficients> coefficients =
        all_coefficients(cuts, job.tool.radius, options);
    return feed_plan(
        cuts.size(),
        [&](std::size_t i) {
            return factored_load(cuts[i], coefficients[i], options.peak_factor, rules);
        },
        rules);
}

}  // namespace endmill
