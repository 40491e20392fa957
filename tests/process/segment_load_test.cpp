// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/segment_load.h"

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/process/feed_plan.h"
#include "milling_examples.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::relative_error;

SegmentCut cut_of(double mu, double lambda, double pick_feed_ratio, double depth_ratio)
{
    return {.length_mm = 1,
            .mu = mu,
            .lambda = lambda,
            .pick_feed_mm = 5 * pick_feed_ratio,
            .depth_mm = 5 * depth_ratio};
}

// docs/methods/ball-end-milling.md, section 4: K = 2000 N/mm^2, limits 1200 N, 450 N
// and 20 N m.
MillingJob job_of_the_vectors()
{
    MillingJob job{test::steel(), test::ball_10(), {}};
    job.material.specific_resistance_n_per_mm2 = 2000;
    job.tool.limits.cutting_force_n = 1200;
    job.tool.limits.thrust_n = 450;
    job.tool.limits.torque_n_m = 20;
    return job;
}

struct Vector {
    SegmentCut cut;
    double torque_peak;
    FeedBounds constant;
    FeedBounds torque;
    FeedBounds direct;
};

const std::vector<Vector> vectors{{cut_of(0, 0, 0.5, 1),
                                   4.35746842,
                                   {0.240286173, 0.456965763, 1.380849618},
                                   {0.08233316, 0.13798964, 0.55265032},
                                   {0.10707872, 0.19863225, 0.56459160}},
                                  {cut_of(0, -0.3, 0.5, 1),
                                   4.25860610,
                                   {0.252753565, 0.476784843, 1.565850146},
                                   {},
                                   {0.11622500, 0.21440328, 0.65566818}},
                                  {cut_of(-0.4, -0.5, 0.4, 2),
                                   2.50892509,
                                   {0.137159625, 0.241501813, 0.832906618},
                                   {},
                                   {0.09211527, 0.15327879, 0.58730613}}};

void expect_bounds(const FeedBounds& bounds, const FeedBounds& expected, double tolerance)
{
    if (!expected.thrust)
        return;
    EXPECT_LT(relative_error(*bounds.cutting_force, *expected.cutting_force), tolerance);
    EXPECT_LT(relative_error(*bounds.thrust, *expected.thrust), tolerance);
    EXPECT_LT(relative_error(*bounds.torque, *expected.torque), tolerance);
}

TEST(SegmentLoad, HasTheBoundsOfIndependentSampling)
{
    const MillingJob job = job_of_the_vectors();
    const FeedRules rules = feed_rules(job, {.form = LimitForm::Exact});
    for (const Vector& vector : vectors) {
        const EngagedCoefficients engaged =
            engaged_coefficients(ball_engagement(vector.cut, 5));
        const SegmentLoad constant = constant_peak_load(vector.cut, engaged, 1.8, rules);
        expect_bounds(constant.bounds, vector.constant, 5e-9);
        EXPECT_EQ(constant.peak_factor, 1.8);
        const SegmentLoad torque =
            torque_peak_load(vector.cut, job.tool, ChipModel::Paper, rules);
        expect_bounds(torque.bounds, vector.torque, 2e-5);
        EXPECT_LT(relative_error(torque.peak_factor.value(), vector.torque_peak), 2e-5);
        const SegmentLoad direct =
            direct_peak_load(vector.cut, job.tool, ChipModel::Paper, rules);
        expect_bounds(direct.bounds, vector.direct, 2e-5);
        EXPECT_FALSE(direct.peak_factor);
    }
}

// At each bound of the feed the load equals the limit, under both rules.
TEST(SegmentLoad, ReachesItsLimitsAtItsBounds)
{
    const MillingJob job = job_of_the_vectors();
    const FeedRules rules = feed_rules(job, {.form = LimitForm::Exact});
    for (const Vector& vector : vectors)
        for (const auto load_of : {torque_peak_load, direct_peak_load}) {
            const SegmentLoad load =
                load_of(vector.cut, job.tool, ChipModel::Exact, rules);
            EXPECT_LT(relative_error(
                          load.loads(*load.bounds.cutting_force).cutting_force_n, 1200),
                      2e-5);
            EXPECT_LT(relative_error(load.loads(*load.bounds.thrust).thrust_n, 450),
                      2e-5);
            EXPECT_LT(relative_error(load.loads(*load.bounds.torque).torque_n_m, 20),
                      2e-5);
        }
}

TEST(SegmentLoad, LifeAngleIsThatOfTheCutWithinItsBounds)
{
    // A level cut as deep as the ball has cos(phi) = 1 - R_p at the height of the centre.
    EXPECT_NEAR(
        tool_life_angle({.mu = 0, .lambda = 0, .pick_feed_ratio = 0.5, .depth_ratio = 1}),
        pi / 3, 1e-7);
    EXPECT_NEAR(tool_life_angle(
                    {.mu = 0, .lambda = 0, .pick_feed_ratio = 1e-4, .depth_ratio = 1}),
                pi / 36, 1e-15);
    EXPECT_EQ(tool_life_angle({.mu = 0,
                               .lambda = 0,
                               .pick_feed_ratio = 0,
                               .depth_ratio = 1,
                               .previous = PreviousPass::None}),
              pi);
    EXPECT_EQ(tool_life_angle({.mu = 0,
                               .lambda = 0,
                               .pick_feed_ratio = 0,
                               .depth_ratio = 1,
                               .previous = PreviousPass::Edge}),
              pi / 2);
    EXPECT_NEAR(tool_life_angle({.mu = 0,
                                 .lambda = 0,
                                 .pick_feed_ratio = 0,
                                 .depth_ratio = -1,
                                 .previous = PreviousPass::None}),
                pi / 36, 1e-15);
    // Full rings at negative lambda count for half a turn at most.
    EXPECT_LE(
        tool_life_angle(
            {.mu = -0.8, .lambda = -0.6, .pick_feed_ratio = 0.6, .depth_ratio = 0.1}),
        pi);
}

TEST(SegmentLoad, TakesTheEngagementFromTheMove)
{
    const BallEngagement engagement = ball_engagement(cut_of(0.1, 0.2, 0.3, 0.4), 5);
    EXPECT_EQ(engagement.mu, 0.1);
    EXPECT_EQ(engagement.lambda, 0.2);
    EXPECT_NEAR(engagement.pick_feed_ratio, 0.3, 1e-15);
    EXPECT_NEAR(engagement.depth_ratio, 0.4, 1e-15);
    EXPECT_EQ(engagement.previous, PreviousPass::Beside);
    SegmentCut first{.length_mm = 1, .depth_mm = 2, .previous = PreviousPass::Edge};
    EXPECT_NO_THROW(ball_engagement(first, 5));
    first.previous = PreviousPass::Beside;
    EXPECT_THROW(ball_engagement(first, 5), DomainError);
    EXPECT_THROW(ball_engagement(cut_of(1.6, 0, 0.3, 0.4), 5), DomainError);
    EXPECT_THROW(ball_engagement(cut_of(0, 0, -0.3, 0.4), 5), DomainError);
}

TEST(SegmentLoad, SumsAreThoseOfAllFlutes)
{
    const EdgeSums sums = edge_sums(
        {.I1 = 1, .I2 = 2, .I3 = 3, .I4 = 4, .I5 = 5, .I6 = 6, .I7 = 7, .I8 = 8}, 3, 2);
    EXPECT_EQ(sums.chip, 30);
    EXPECT_EQ(sums.edge, 36);
    EXPECT_EQ(sums.chip_torque, 42);
    EXPECT_EQ(sums.edge_torque, 48);
}

TEST(TurningLoad, NamesAMoveThatIsCutTooDeepForItsHelix)
{
    const SegmentCut cut{.pass = 3,
                         .point = 7,
                         .length_mm = 1,
                         .depth_mm = 5e6,
                         .previous = PreviousPass::None};
    const MillingTool tool{5, 2, 0.5};
    FeedRules rules{};
    rules.model = {{2000, 0.016, 0.4, 0.4, 0.2, 0.6, 0.37, 28}, 5};
    try {
        torque_peak_load(cut, tool, ChipModel::Paper, rules);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_NE(std::string{error.what()}.find("point 7 of pass 3"), std::string::npos);
    }
}

// The default SegmentCut states no pick feed and lies in air.
TEST(SegmentLoad, TreatsADefaultMoveAsACutInAir)
{
    const SegmentCut cut;
    EXPECT_FALSE(cut.mu || cut.pick_feed_mm || cut.pick_feed_horizontal_mm);
    EXPECT_EQ(cut.length_mm, 0);
    EXPECT_EQ(cut.previous, PreviousPass::Beside);
    EXPECT_EQ(cut.milling, Milling::Down);
    SegmentCut first = cut;
    first.previous = PreviousPass::None;
    EXPECT_TRUE(is_air(ball_engagement(first, 5)));
}

}  // namespace
}  // namespace endmill
