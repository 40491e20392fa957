// SPDX-License-Identifier: GPL-3.0-or-later
#include "ball-end-milling/equations/printed_limits.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/process/detail/segment_load.h"
#include "endmill/process/detail/stroke_forces.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double n_per_kgf = 9.80665;

// Relative difference of the printed force of eq. (15) from the magnitude of tangential
// and radial force, for a slot of the depth of the radius.
double force_deviation(CuttingMaterial material, double r1, double r2, double feed_mm)
{
    material.r1 = r1;
    material.r2 = r2;
    const BallEngagement slot{0, 0, 0, 1, PreviousPass::None};
    const EdgeSums sums = edge_sums(cutting_coefficients(slot), 1, 1);
    const auto force = [&](LimitForm form) {
        return cutting_loads({material, 1, form}, sums, feed_mm).cutting_force_n;
    };
    return std::abs(force(LimitForm::Paper) / force(LimitForm::Exact) - 1);
}

// Relative difference of the printed eq. (18) from the spindle speed of the cutting speed
// V = C_b / (phi/pi T0)^alpha.
double speed_deviation(const MillingJob& job, double phi_over_pi, double life_min)
{
    const SpeedLine line{job.material.alpha, job.material.v1_m_per_min};
    const double cb = tool_life_constant(line, life_min);
    const double printed =
        cb / (pi * job.tool.radius * phi_over_pi * std::pow(life_min, line.alpha));
    const double right =
        spindle_speed_rpm(economic_speed(line, phi_over_pi), job.tool.radius);
    return std::abs(printed / right - 1);
}

}  // namespace

void add_limit_equations(CsvTable& result, const MillingJob& job, const LimitCases& cases)
{
    const double feed_mm = cases.feed_per_tooth_mm;
    add_named(
        result, "eq. (15)",
        {{"deviation", force_deviation(job.material, cases.r1, cases.r2, feed_mm)}});
    add_named(
        result, "eq. (15), r2 = r1",
        {{"deviation", force_deviation(job.material, cases.r1, cases.r1, feed_mm)}});
    add_named(result, "eq. (18)",
              {{"deviation", std::min(speed_deviation(job, 1, cases.life_min),
                                      speed_deviation(job, 0.5, cases.life_min))}});
    // kW = W / 1000, N m = kgf mm g / 1000, and 2 pi n / 60 in rad/s.
    add_named(result, "eq. (19)", {{"constant", 60e6 / (2 * pi * n_per_kgf)}});
}

void add_independence(CsvTable& result, const std::vector<SegmentCut>& cuts,
                      const MillingJob& job)
{
    MillingJob slow = job;
    slow.material.v1_m_per_min /= 2;
    const FeedPlan one = feed_plan(cuts, job, {});
    const FeedPlan other = feed_plan(cuts, slow, {});
    double change = 0;
    for (std::size_t i = 0; i < cuts.size(); ++i)
        change = std::max(change, std::abs(other.rows[i].tooth.feed_per_tooth_mm /
                                               one.rows[i].tooth.feed_per_tooth_mm -
                                           1));
    add_named(result, "limits on feed or speed alone",
              {{"change_percent", 100 * change}});
    std::vector<MilledMove> less_speed = milled_moves(cuts, one, {});
    std::vector<MilledMove> less_feed = less_speed;
    for (std::size_t i = 0; i < cuts.size(); ++i) {
        less_speed[i].spindle_rpm /= 2;
        less_feed[i].feed_per_tooth_mm /= 2;
    }
    constexpr double any_life_min = 1;  // it cancels
    add_named(result, "less speed or less feed",
              {{"wear_ratio", used_life(less_speed, job, any_life_min) /
                                  used_life(less_feed, job, any_life_min)}});
}

}  // namespace endmill
