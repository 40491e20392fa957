// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_plan.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "milling_examples.h"

namespace endmill {
namespace {

MillingJob job()
{
    return {test::steel(), test::ball_10(), test::mill_3000()};
}

TEST(FeedOptions, AreThePapersUnlessCorrected)
{
    const FeedPlanOptions paper;
    EXPECT_EQ(paper.chip, ChipModel::Paper);
    EXPECT_EQ(paper.peak, PeakRule::Constant);
    EXPECT_EQ(paper.peak_factor, 1.8);
    EXPECT_EQ(paper.form, LimitForm::Paper);
    const FeedPlanOptions corrected = corrected_feed_options();
    EXPECT_EQ(corrected.chip, ChipModel::Exact);
    EXPECT_EQ(corrected.peak, PeakRule::Direct);
    EXPECT_EQ(corrected.form, LimitForm::Exact);
    EXPECT_EQ(corrected.block_time_ms, 10);
}

TEST(FeedOptions, RuleOverTheMaterial)
{
    FeedRules rules = feed_rules(job(), {});
    EXPECT_EQ(rules.range.most_mm, 0.15);
    EXPECT_EQ(rules.range.least_mm, 0.005);
    rules =
        feed_rules(job(), {.max_feed_per_tooth_mm = 0.3, .min_feed_per_tooth_mm = 0.01});
    EXPECT_EQ(rules.range.most_mm, 0.3);
    EXPECT_EQ(rules.range.least_mm, 0.01);
    MillingJob silent = job();
    silent.material.max_feed_per_tooth_mm = std::nullopt;
    silent.material.min_feed_per_tooth_mm = std::nullopt;
    rules = feed_rules(silent, {});
    EXPECT_FALSE(rules.range.most_mm);
    EXPECT_EQ(rules.range.least_mm, 0.005);
}

TEST(FeedOptions, TheWeakerOfToolAndSpindleBoundsTheTorque)
{
    MillingJob one = job();
    EXPECT_EQ(feed_rules(one, {}).limits.torque_n_m, one.tool.limits.torque_n_m);
    one.machine.max_torque_n_m = 5;
    EXPECT_EQ(feed_rules(one, {}).limits.torque_n_m, 5);
    one.tool.limits.torque_n_m = 4;
    EXPECT_EQ(feed_rules(one, {}).limits.torque_n_m, 4);
    one.tool.limits.torque_n_m = std::nullopt;
    EXPECT_EQ(feed_rules(one, {}).limits.torque_n_m, 5);
    one.machine.max_torque_n_m = std::nullopt;
    EXPECT_FALSE(feed_rules(one, {}).limits.torque_n_m);
}

TEST(FeedOptions, RefuseUnsoundData)
{
    EXPECT_THROW(feed_rules(job(), {.peak_factor = 0.99}), DomainError);
    EXPECT_NO_THROW(feed_rules(job(), {.peak_factor = 1}));
    EXPECT_THROW(feed_rules(job(), {.min_feed_per_tooth_mm = 0.2}), DomainError);
    EXPECT_THROW(feed_rules(job(), {.block_time_ms = -1}), DomainError);
    MillingJob wrong = job();
    wrong.tool.flutes = 0;
    EXPECT_THROW(feed_rules(wrong, {}), DomainError);
    wrong = job();
    wrong.machine.max_rpm = -1;
    EXPECT_THROW(feed_rules(wrong, {}), DomainError);
    wrong = job();
    wrong.material.specific_resistance_n_per_mm2 = 0;
    EXPECT_THROW(feed_rules(wrong, {}), DomainError);
}

}  // namespace
}  // namespace endmill
