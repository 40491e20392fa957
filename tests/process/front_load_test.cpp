// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/front_load.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/process/detail/engaged_region.h"
#include "endmill/process/detail/force_pattern.h"
#include "endmill/process/detail/segment_load.h"
#include "endmill/process/feed_plan.h"
#include "milling_examples.h"

namespace endmill {
namespace {

using std::numbers::pi;

// The front of an engagement, tested cell by cell.
BallFront front_of(const BallEngagement& engagement, int rows, int columns)
{
    BallFront front{.lambda = engagement.lambda, .rows = rows, .columns = columns};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double y = -1 + 2 * (row + 0.5) / rows;
            const double chi =
                (engagement.lambda - pi / 2) * (1 - (column + 0.5) / columns);
            const double rho = std::sqrt(1 - y * y);
            const double azimuth = std::atan2(rho * std::cos(chi), y);
            const double latitude = std::acos(-rho * std::sin(chi));
            front.engaged.push_back(is_engaged(engagement, latitude, azimuth) ? 1 : 0);
        }
    const double angle = shank_angle(engagement);
    for (int k = 0; k < columns; ++k) {
        const bool is_in = pi * (k + 0.5) / columns < angle;
        front.shank.push_back(is_in ? std::max(engagement.depth_ratio - 1, 0.0) : 0);
    }
    return front;
}

std::array<double, 8> numbers_of(const CuttingCoefficients& c)
{
    return {c.I1, c.I2, c.I3, c.I4, c.I5, c.I6, c.I7, c.I8};
}

const std::vector<BallEngagement> engagements{{0, 0, 0.5, 1},
                                              {0, 0, 0.5, 0.5},
                                              {0, 0, 0.5, 2},
                                              {-0.4, 0, 0.3, 3},
                                              {0.3, 0.2, 0.4, 0.6},
                                              {0.4, -0.3, 0.5, 1},
                                              {-0.8, -0.6, 0.6, 0.35},
                                              {0, 0.3, 0.5, 1, PreviousPass::None},
                                              {0, -0.3, 0.5, 1.4, PreviousPass::Edge}};

TEST(FrontCoefficients, TendToThoseOfTheBorders)
{
    for (const BallEngagement& engagement : engagements)
        for (const ChipModel chip : {ChipModel::Paper, ChipModel::Exact}) {
            const auto exact = numbers_of(cutting_coefficients(engagement, chip));
            const auto coarse =
                numbers_of(front_coefficients(front_of(engagement, 96, 128), chip));
            const auto fine =
                numbers_of(front_coefficients(front_of(engagement, 384, 512), chip));
            for (std::size_t k = 0; k < exact.size(); ++k) {
                // The shank's angle is a whole number of azimuth steps, of which one is
                // 1/256 of a turn.
                const double shank = std::max(engagement.depth_ratio - 1, 0.0);
                EXPECT_NEAR(coarse[k], exact[k], 3e-3 + shank / 256);
                EXPECT_NEAR(fine[k], exact[k], 8e-4 + shank / 1024);
            }
        }
}

TEST(FrontCoefficients, OfAirAreZero)
{
    BallFront front = front_of({0, 0, 0.5, 1}, 96, 128);
    for (char& cell : front.engaged)
        cell = 0;
    for (const double i : numbers_of(front_coefficients(front, ChipModel::Paper))) {
        EXPECT_EQ(i, 0);
    }
    EXPECT_EQ((FrontPattern{front, ChipModel::Paper, {5, 2, 0.5}}.peak_factor()), 1);
}

// Compared with the pattern that uses exact crossings of edges and borders.
TEST(FrontPattern, TendsToThatOfTheBorders)
{
    const MillingTool tool{5, 2, pi / 6};
    for (const BallEngagement& engagement : engagements) {
        const ForcePattern exact{engagement, ChipModel::Paper, tool};
        const FrontPattern front{front_of(engagement, 96, 128), ChipModel::Paper, tool};
        EXPECT_NEAR(front.peak_factor(), exact.peak_factor(), 0.05 * exact.peak_factor());
        EXPECT_NEAR(front.mean().chip, exact.mean().chip, 0.02 * exact.mean().chip);
        EXPECT_NEAR(front.mean().edge_torque, exact.mean().edge_torque,
                    0.02 * exact.mean().edge_torque);
    }
}

TEST(FrontLoad, IsThatOfTheSameEngagementInClosedForm)
{
    const MillingJob job{test::steel(), test::ball_10(), {}};
    FeedPlanOptions options;
    options.max_feed_per_tooth_mm = 1;
    const FeedRules rules = feed_rules(job, options);
    BallFront front = front_of({0, 0, 0.5, 1}, 96, 128);
    front.rim_angle = pi / 3;
    for (const PeakRule peak : {PeakRule::Constant, PeakRule::Torque, PeakRule::Direct}) {
        options.peak = peak;
        const SegmentLoad load = front_load(2, front, job.tool, options, rules);
        SegmentCut cut{.length_mm = 2, .mu = 0, .pick_feed_mm = 2.5, .depth_mm = 5};
        const SegmentLoad closed =
            peak == PeakRule::Constant
                ? constant_peak_load(cut, engaged_coefficients({0, 0, 0.5, 1}), 1.8,
                                     rules)
            : peak == PeakRule::Torque
                ? torque_peak_load(cut, job.tool, ChipModel::Paper, rules)
                : direct_peak_load(cut, job.tool, ChipModel::Paper, rules);
        EXPECT_NEAR(load.engaged_angle, closed.engaged_angle, 1e-9);
        EXPECT_EQ(load.peak_factor.has_value(), closed.peak_factor.has_value());
        EXPECT_NEAR(load.bounds.cutting_force.value(),
                    closed.bounds.cutting_force.value(),
                    0.06 * closed.bounds.cutting_force.value());
        EXPECT_NEAR(load.loads(0.1).thrust_n, closed.loads(0.1).thrust_n,
                    0.04 * closed.loads(0.1).thrust_n);
    }
}

// A move in air, and one whose front is visited first; each is planned by itself.
TEST(MeasuredFeedPlan, IsTheFeedOfEachFrontInWhateverOrder)
{
    const MillingJob job{test::steel(), test::ball_10(), {}};
    FeedPlanOptions options;
    options.max_feed_per_tooth_mm = 0.3;
    const std::vector<SegmentCut> cuts{{.length_mm = 2}, {.length_mm = 3}};
    std::vector<BallFront> fronts(2, front_of({0, 0, 0.5, 1}, 96, 128));
    fronts[0].rim_angle = pi / 3;
    fronts[0].stock_side = FeedSide::Left;
    fronts[1].engaged.assign(fronts[1].engaged.size(), 0);
    const MeasuredFeeds found =
        measured_feed_plan(cuts, job, options, [&](const FrontVisit& visit) {
            visit(1, fronts[1]);
            visit(0, fronts[0]);
        });
    const FeedRules rules = feed_rules(job, options);
    double cut_min = 0;
    for (std::size_t k = 0; k < 2; ++k) {
        const SegmentFeed alone = segment_feed(
            front_load(cuts[k].length_mm, fronts[k], job.tool, options, rules), rules);
        EXPECT_EQ(found.plan.rows[k].table.feed_mm_per_min, alone.table.feed_mm_per_min);
        cut_min += cuts[k].length_mm / alone.table.feed_mm_per_min;
    }
    EXPECT_NEAR(found.plan.totals.cut_min, cut_min, 1e-12 * cut_min);
    EXPECT_EQ(found.milling, (std::vector{Milling::Up, Milling::Down}));
    EXPECT_TRUE(found.has_engagement);
    const auto air = [&](const FrontVisit& visit) {
        visit(0, fronts[1]);
        visit(1, fronts[1]);
    };
    EXPECT_FALSE(measured_feed_plan(cuts, job, options, air).has_engagement);
}

TEST(FrontLoad, NeedsASoundFront)
{
    BallFront front = front_of({0, 0, 0.5, 1}, 8, 8);
    EXPECT_NO_THROW(require_sound(front));
    front.engaged.pop_back();
    EXPECT_THROW(front_coefficients(front, ChipModel::Paper), DomainError);
    front = front_of({0, 0, 0.5, 1}, 8, 8);
    front.shank[3] = std::nan("");
    EXPECT_THROW((FrontPattern{front, ChipModel::Paper, {5, 2, 0.5}}), DomainError);
    front = front_of({0, 0, 0.5, 1}, 8, 8);
    front.lambda = pi / 2;
    EXPECT_THROW(require_sound(front), DomainError);
}

}  // namespace
}  // namespace endmill
