// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "milling_examples.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::relative_error;

FeedRules rules(const LoadLimits& limits)
{
    CuttingMaterial material = test::steel();
    material.specific_resistance_n_per_mm2 = 2000;
    return {.model = {material, 5, LimitForm::Paper},
            .limits = limits,
            .range = {.most_mm = 0.15, .least_mm = 0.005},
            .drive = {.radius = 5,
                      .flutes = 2,
                      .speed = {0.3680141, 28.4313},
                      .machine = {},
                      .form = LimitForm::Paper}};
}

// A slot one radius deep with two teeth; each load is 1.8 times its mean.
SegmentLoad slot(double length, const FeedRules& rules)
{
    const EdgeSums sums = scaled({1 / pi, 0.5, 0.25, pi / 8}, 2 * 1.8);
    return {.length_mm = length,
            .engaged_angle = pi,
            .bounds = feed_bounds(rules.model, sums, rules.limits),
            .loads = [sums, &rules](
                         double feed) { return cutting_loads(rules.model, sums, feed); },
            .peak_factor = 1.8};
}

// docs/methods/ball-end-milling.md, section 9, A14.
TEST(SegmentFeed, OfASlotIsClosed)
{
    const FeedRules slack = rules({.cutting_force_n = 1200});
    const SegmentFeed feed = segment_feed(slot(100, slack), slack);
    EXPECT_LT(relative_error(feed.tooth.feed_per_tooth_mm, 0.072097110475), 1e-9);
    EXPECT_LT(relative_error(feed.table.spindle_rpm, 904.996386706), 1e-9);
    EXPECT_LT(relative_error(feed.table.feed_mm_per_min, 130.495248944), 1e-9);
    EXPECT_EQ(reported_limit(feed), FeedLimit::CuttingForce);
    EXPECT_EQ(feed.table.speed_limit, SpeedLimit::EconomicSpeed);
    EXPECT_LT(relative_error(feed.loads.cutting_force_n, 1200), 1e-14);
}

TEST(SegmentFeed, ReportsInfeasibleBeforeBlockRateBeforeTheGoverningLimit)
{
    const FeedRules slack = rules({.cutting_force_n = 1200});
    EXPECT_EQ(reported_limit(segment_feed(slot(0.001, slack), slack)),
              FeedLimit::BlockRate);
    EXPECT_EQ(segment_feed(slot(0.001, slack), slack).tooth.governing,
              FeedLimit::CuttingForce);
    const FeedRules tight = rules({.cutting_force_n = 300});
    const SegmentFeed feed = segment_feed(slot(1e-6, tight), tight);
    EXPECT_EQ(reported_limit(feed), FeedLimit::Infeasible);
    EXPECT_TRUE(feed.table.is_block_bound);
    EXPECT_EQ(feed.tooth.feed_per_tooth_mm, 0.005);
    EXPECT_GT(feed.loads.cutting_force_n, 300);
}

TEST(SegmentFeed, InAirIsTheCapWithoutLoads)
{
    const FeedRules slack = rules({.cutting_force_n = 1200});
    const SegmentFeed feed = segment_feed(
        {.length_mm = 10, .engaged_angle = pi / 36, .bounds = {}, .loads = {}}, slack);
    EXPECT_EQ(feed.tooth.feed_per_tooth_mm, 0.15);
    EXPECT_EQ(reported_limit(feed), FeedLimit::Cap);
    EXPECT_EQ(feed.loads.cutting_force_n, 0);
    EXPECT_EQ(feed.table.power_w, 0);
    EXPECT_FALSE(feed.peak_factor);
}

// The limits hold at the returned feed, except where it is marked as infeasible.
TEST(SegmentFeed, KeepsItsLimitsOrIsInfeasible)
{
    test::Random random{3};
    for (int i = 0; i < 500; ++i) {
        FeedRules all = rules({random.log_uniform(100, 3000),
                               random.log_uniform(50, 1000), random.log_uniform(1, 20)});
        all.drive.machine = {.max_rpm = random.uniform(500, 3000),
                             .max_power_w = random.log_uniform(20, 2000),
                             .max_feed_mm_per_min = random.uniform(50, 400)};
        const double length = random.log_uniform(1e-3, 10);
        const SegmentFeed feed = segment_feed(slot(length, all), all);
        if (!feed.tooth.is_infeasible) {
            EXPECT_LE(feed.loads.cutting_force_n,
                      *all.limits.cutting_force_n * (1 + 1e-8));
            EXPECT_LE(feed.loads.thrust_n, *all.limits.thrust_n * (1 + 1e-8));
            EXPECT_LE(feed.loads.torque_n_m, *all.limits.torque_n_m * (1 + 1e-8));
        }
        EXPECT_LE(feed.tooth.feed_per_tooth_mm, 0.15);
        EXPECT_LE(feed.table.spindle_rpm, *all.drive.machine.max_rpm);
        EXPECT_LE(feed.table.power_w, *all.drive.machine.max_power_w * (1 + 1e-12));
        EXPECT_LE(feed.table.feed_mm_per_min,
                  *all.drive.machine.max_feed_mm_per_min * (1 + 1e-12));
        EXPECT_LE(feed.table.feed_mm_per_min, 6000 * length * (1 + 1e-12));
    }
}

TEST(SegmentFeed, RulesMustBeSound)
{
    EXPECT_NO_THROW(require_sound(rules({})));
    EXPECT_THROW(require_sound(rules({.thrust_n = 0})), DomainError);
    FeedRules wrong = rules({});
    wrong.model.radius = 0;
    EXPECT_THROW(require_sound(wrong), DomainError);
    wrong = rules({});
    wrong.model.material.alpha = 1;
    EXPECT_THROW(require_sound(wrong), DomainError);
    wrong = rules({});
    wrong.range.least_mm = 1;
    EXPECT_THROW(require_sound(wrong), DomainError);
    wrong = rules({});
    wrong.drive.flutes = 0;
    EXPECT_THROW(require_sound(wrong), DomainError);
}

}  // namespace
}  // namespace endmill
