// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <numbers>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/process/detail/front_load.h"
#include "endmill/process/detail/segment_load.h"

// A plan treats every move by itself, in three steps:
// 1. The geometry of the cut gives the engagement, and this gives the load: sums of the
//    edges and bounds of the feed per tooth (detail/segment_load.h, detail/front_load.h).
// 2. `segment_feed` runs the stages I to IV for the move.
// 3. FeedTotalsSum adds up the rows in the order of the moves.
// Steps 1 and 2 run on all threads. Their results are stored by the number of the move,
// so the plan does not depend on the number of threads.

namespace endmill {
namespace {

// Relative margin of a needed limit. It exceeds the error of 1e-5 of the largest load in
// a revolution, so that a plan with the needed limit admits the least feed.
constexpr double needed_margin = 2e-5;

// Raises `needed` to the limit that `load` needs, if `load` exceeds `limit`.
void raise(std::optional<double>& needed, double load, const std::optional<double>& limit)
{
    if (limit && load > *limit)
        needed = std::max(needed.value_or(0), (1 + needed_margin) * load);
}

// Coefficients and engaged angle of a cut, from the table if the options name one.
EngagedCoefficients coefficients_of(const SegmentCut& cut, double radius,
                                    const FeedPlanOptions& options)
{
    const BallEngagement engagement = ball_engagement(cut, radius);
    if (options.table == nullptr)
        return engaged_coefficients(engagement, options.chip, options.accuracy);
    return {options.table->coefficients(engagement), engaged_angle(engagement)};
}

// The smaller of two limits; a missing limit does not bind.
std::optional<double> smaller(const std::optional<double>& one,
                              const std::optional<double>& other)
{
    if (one && other)
        return std::min(*one, *other);
    return one ? one : other;
}

bool is_engaged(const BallFront& front)
{
    const auto is_material = [](double value) { return value > 0; };
    return std::ranges::any_of(front.engaged, is_material) ||
           std::ranges::any_of(front.shank, is_material);
}

}  // namespace

FeedRange feed_range(const CuttingMaterial& material, const FeedPlanOptions& options)
{
    FeedRange range;
    range.most_mm = options.max_feed_per_tooth_mm ? options.max_feed_per_tooth_mm
                                                  : material.max_feed_per_tooth_mm;
    range.least_mm = options.min_feed_per_tooth_mm.value_or(
        material.min_feed_per_tooth_mm.value_or(range.least_mm));
    return range;
}

FeedPlanOptions corrected_feed_options()
{
    FeedPlanOptions options;
    options.chip = ChipModel::Exact;
    options.peak = PeakRule::Direct;
    options.form = LimitForm::Exact;
    return options;
}

FeedRules feed_rules(const MillingJob& job, const FeedPlanOptions& options)
{
    require_sound(job.tool);
    require(std::isfinite(options.peak_factor) && options.peak_factor >= 1,
            "feed plan: need 1 <= peak factor");
    const FeedRules rules{
        .model = {job.material, job.tool.radius, options.form},
        .limits = {job.tool.limits.cutting_force_n, job.tool.limits.thrust_n,
                   smaller(job.tool.limits.torque_n_m, job.machine.max_torque_n_m)},
        .range = feed_range(job.material, options),
        .drive = {.radius = job.tool.radius,
                  .flutes = job.tool.flutes,
                  .speed = {job.material.alpha, job.material.v1_m_per_min},
                  .machine = job.machine,
                  .form = options.form,
                  .block_time_ms = options.block_time_ms}};
    require_sound(rules);
    return rules;
}

SegmentLoad front_load(double length_mm, const BallFront& front, const MillingTool& tool,
                       const FeedPlanOptions& options, const FeedRules& rules)
{
    const double angle = std::clamp(front.rim_angle, least_life_angle, std::numbers::pi);
    const auto load_of_sums = [&](const EdgeSums& sums, double factor) {
        return SegmentLoad{
            .length_mm = length_mm,
            .engaged_angle = angle,
            .bounds = feed_bounds(rules.model, sums, rules.limits),
            .loads = [sums, &rules](
                         double feed) { return cutting_loads(rules.model, sums, feed); },
            .peak_factor = factor};
    };
    if (options.peak == PeakRule::Constant)
        return load_of_sums(edge_sums(front_coefficients(front, options.chip),
                                      tool.flutes, options.peak_factor),
                            options.peak_factor);
    // A shared pointer, because a std::function must be copyable.
    const auto pattern = std::make_shared<const FrontPattern>(front, options.chip, tool);
    if (options.peak == PeakRule::Torque) {
        const double factor = pattern->peak_factor();
        return load_of_sums(scaled(pattern->mean(), factor), factor);
    }
    return {.length_mm = length_mm,
            .engaged_angle = angle,
            .bounds = pattern->direct_bounds(rules.model, rules.limits),
            .loads = [pattern, &rules](double feed) {
                return pattern->largest_loads(rules.model, feed);
            }};
}

MeasuredFeeds measured_feed_plan(
    std::span<const SegmentCut> cuts, const MillingJob& job,
    const FeedPlanOptions& options,
    const std::function<void(const FrontVisit& visit)>& measure)
{
    const FeedRules rules = feed_rules(job, options);
    MeasuredFeeds measured;
    measured.plan.rows.resize(cuts.size());
    measured.milling.resize(cuts.size(), Milling::Down);
    std::vector<double> lengths;
    for (const SegmentCut& cut : cuts)
        lengths.push_back(cut.length_mm);
    std::atomic<bool> has_engagement = false;
    measure([&](std::size_t number, const BallFront& front) {
        if (is_engaged(front))
            has_engagement = true;
        measured.milling[number] =
            front.stock_side == FeedSide::Right ? Milling::Down : Milling::Up;
        measured.plan.rows[number] = segment_feed(
            front_load(lengths[number], front, job.tool, options, rules), rules);
    });
    measured.has_engagement = has_engagement;
    measured.plan.totals = feed_plan_totals(measured.plan.rows, lengths, rules.limits);
    return measured;
}

void FeedTotalsSum::add(const SegmentFeed& row, double length_mm)
{
    sum_.length_mm += length_mm;
    sum_.cut_min += length_mm / row.table.feed_mm_per_min;
    sum_.limit_shares[static_cast<std::size_t>(reported_limit(row))] += length_mm;
    sum_.speed_limit_shares[static_cast<std::size_t>(row.table.speed_limit)] += length_mm;
    sum_.max_torque_n_m = std::max(sum_.max_torque_n_m, row.loads.torque_n_m);
    sum_.max_power_w = std::max(sum_.max_power_w, row.table.power_w);
    if (!row.tooth.is_infeasible)
        return;
    ++sum_.infeasible;
    LoadLimits& needed = sum_.needed;
    raise(needed.cutting_force_n, row.loads.cutting_force_n, limits_.cutting_force_n);
    raise(needed.thrust_n, row.loads.thrust_n, limits_.thrust_n);
    raise(needed.torque_n_m, row.loads.torque_n_m, limits_.torque_n_m);
}

FeedPlanTotals FeedTotalsSum::totals() const
{
    FeedPlanTotals totals = sum_;
    if (!(totals.length_mm > 0))
        return totals;
    for (double& share : totals.limit_shares)
        share /= totals.length_mm;
    for (double& share : totals.speed_limit_shares)
        share /= totals.length_mm;
    return totals;
}

FeedPlanTotals feed_plan_totals(const std::vector<SegmentFeed>& rows,
                                const std::vector<double>& lengths_mm,
                                const LoadLimits& limits)
{
    require(rows.size() == lengths_mm.size(),
            "feed_plan_totals: need one length per row");
    FeedTotalsSum sum{limits};
    for (std::size_t i = 0; i < rows.size(); ++i)
        sum.add(rows[i], lengths_mm[i]);
    return sum.totals();
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
    if (options.peak == PeakRule::Torque)
        return feed_plan(
            cuts.size(),
            [&](std::size_t i) {
                return torque_peak_load(cuts[i], job.tool, options.chip, rules);
            },
            rules);
    if (options.peak == PeakRule::Direct)
        return feed_plan(
            cuts.size(),
            [&](std::size_t i) {
                return direct_peak_load(cuts[i], job.tool, options.chip, rules);
            },
            rules);
    return feed_plan(
        cuts.size(),
        [&](std::size_t i) {
            return constant_peak_load(cuts[i],
                                      coefficients_of(cuts[i], job.tool.radius, options),
                                      options.peak_factor, rules);
        },
        rules);
}

}  // namespace endmill
