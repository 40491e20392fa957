// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"

namespace endmill {
namespace {

std::optional<double> smaller(const std::optional<double>& one,
                              const std::optional<double>& other)
{
    if (one && other)
        return std::min(*one, *other);
    return one ? one : other;
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
        .limits = {job.tool.cutting_force_n, job.tool.thrust_n,
                   smaller(job.tool.torque_n_m, job.machine.max_torque_n_m)},
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

}  // namespace endmill
