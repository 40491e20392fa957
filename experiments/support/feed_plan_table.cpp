// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/feed_plan_table.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include "endmill/core/angle.h"
#include "endmill/core/vec.h"
#include "endmill/process/fed_path.h"
#include "support/milling_jobs.h"

namespace endmill {
namespace {

// Quantiles of the peak factor over the cutting moves that have one.
NamedCells peak_cells(const FeedPlan& plan)
{
    std::vector<double> factors;
    for (const SegmentFeed& row : plan.rows)
        if (row.peak_factor)
            factors.push_back(*row.peak_factor);
    if (factors.empty())
        return {};
    std::ranges::sort(factors);
    const auto quantile = [&](double share) {
        return factors[static_cast<std::size_t>(share *
                                                static_cast<double>(factors.size() - 1))];
    };
    return {{"peak_factor_5", quantile(0.05)},
            {"peak_factor_50", quantile(0.5)},
            {"peak_factor_95", quantile(0.95)},
            {"peak_factor_greatest", factors.back()}};
}

NamedCells thrust_cells(const std::vector<SegmentCut>& cuts, const FeedPlan& plan)
{
    double count = 0;
    Vec3 sums{0, 0, 0};  // of depth, lambda, mu
    double all_depths = 0;
    for (const SegmentCut& cut : cuts)
        all_depths += cut.depth_mm;
    const double mean_depth = all_depths / static_cast<double>(cuts.size());
    double length = 0;
    double length_of_all_three = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        if (reported_limit(plan.rows[i]) == FeedLimit::Thrust) {
            const SegmentCut& cut = cuts[i];
            const double mu = cut.mu.value_or(0);
            ++count;
            sums += Vec3{cut.depth_mm, Angle::radians(cut.lambda).degrees(),
                         Angle::radians(mu).degrees()};
            length += cut.length_mm;
            if (cut.depth_mm > mean_depth && cut.lambda < 0 && mu < 0)
                length_of_all_three += cut.length_mm;
        }
    if (count == 0)
        return {};
    const Vec3 means = sums / count;
    return {{"thrust_depth_mm", means.x()},
            {"thrust_lambda_deg", means.y()},
            {"thrust_mu_deg", means.z()},
            {"thrust_deep_downhill",
             word(means.x() > mean_depth && means.y() < 0 && means.z() < 0)},
            {"thrust_all_three_percent", 100 * length_of_all_three / length}};
}

}  // namespace

NamedCells time_cells(const FeedPlan& plan, const ConstantFeed& constant)
{
    const FeedPlanTotals& totals = plan.totals;
    const FeedTimes times =
        feed_times({.cut_length_mm = totals.length_mm,
                    .cut_min = totals.cut_min,
                    .noncut_min = constant.noncut_min,
                    .constant_feed_mm_per_min = constant.feed_mm_per_min});
    return {
        {"cut_min", totals.cut_min},
        {"mean_feed_mm_per_min", totals.length_mm / totals.cut_min},
        {"total_min", times.total_min.value()},
        {"saving_percent", times.saving_percent.value()},
        {"cut_saving_percent",
         saving_percent(totals.cut_min, totals.length_mm / constant.feed_mm_per_min)}};
}

NamedCells limit_cells(const FeedPlan& plan)
{
    constexpr std::array limits{"force_share", "thrust_share", "torque_share",
                                "cap_share",   "block_share",  "infeasible_share"};
    constexpr std::array speeds{"economic_share", "spindle_share", "power_share",
                                "drive_share"};
    const FeedPlanTotals& totals = plan.totals;
    NamedCells cells;
    for (std::size_t i = 0; i < limits.size(); ++i)
        cells.emplace_back(limits[i], totals.limit_shares[i]);
    for (std::size_t i = 0; i < speeds.size(); ++i)
        cells.emplace_back(speeds[i], totals.speed_limit_shares[i]);
    cells.emplace_back("infeasible", static_cast<std::int64_t>(totals.infeasible));
    cells.emplace_back("max_torque_n_m", totals.max_torque_n_m);
    cells.emplace_back("max_power_w", totals.max_power_w);
    return cells;
}

NamedCells limit_claims(const std::vector<FeedPlan>& plans)
{
    const auto all = [&](auto holds) {
        return word(std::ranges::all_of(
            plans, [&](const FeedPlan& plan) { return holds(plan.totals); }));
    };
    const auto mostly_force = [](const FeedPlanTotals& totals) {
        return limit_share(totals, FeedLimit::CuttingForce) > 0.5;
    };
    const auto thrust = [](const FeedPlanTotals& totals) {
        return limit_share(totals, FeedLimit::Thrust) > 0;
    };
    const auto neither = [](const FeedPlanTotals& totals) {
        return limit_share(totals, FeedLimit::Torque) == 0 &&
               limit_share(totals, SpeedLimit::Power) == 0;
    };
    return {{"mostly_force", all(mostly_force)},
            {"sometimes_thrust", all(thrust)},
            {"never_torque_or_power", all(neither)}};
}

NamedCells sensitivity_cells(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                             double noncut_min)
{
    const FeedPlanTotals& totals = plan.totals;
    NamedCells cells{{"total_min", totals.cut_min + noncut_min},
                     {"force_share", limit_share(totals, FeedLimit::CuttingForce)},
                     {"thrust_share", limit_share(totals, FeedLimit::Thrust)},
                     {"cap_share", limit_share(totals, FeedLimit::Cap)},
                     {"infeasible_share", limit_share(totals, FeedLimit::Infeasible)},
                     {"infeasible", static_cast<std::int64_t>(totals.infeasible)}};
    return joined(joined(cells, peak_cells(plan)), thrust_cells(cuts, plan));
}

}  // namespace endmill
