// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/stroke_forces.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/process/detail/segment_load.h"
#include "milling_examples.h"
#include "random.h"

namespace endmill {
namespace {

using test::relative_error;

MillingJob steel_job()
{
    return {test::steel(), test::ball_10(), test::mill_3000()};
}

// A slot 20 mm long and 1 mm deep.
SegmentCut slot(double lambda = 0)
{
    return {
        .length_mm = 20, .lambda = lambda, .depth_mm = 1, .previous = PreviousPass::None};
}

MilledMove milled(const SegmentCut& cut)
{
    return {cut, /*feed_per_tooth_mm=*/0.1, /*spindle_rpm=*/500};
}

TEST(StrokeForces, OfATurnHaveTheMeanThatTheCoefficientsGive)
{
    const MillingJob job = steel_job();
    const MilledMove move = milled(slot(0.2));
    const int steps = 3600;
    CuttingForce sum{};
    for (const CuttingForce& force : turn_forces(move, job, steps)) {
        sum.x_n += force.x_n / steps;
        sum.y_n += force.y_n / steps;
        sum.z_n += force.z_n / steps;
    }
    const CuttingForce mean =
        mean_force(cutting_coefficients(ball_engagement(move.cut, job.tool.radius),
                                        ChipModel::Paper),
                   job.material, job.tool, move.feed_per_tooth_mm, move.cut.milling);
    EXPECT_LT(relative_error(sum.x_n, mean.x_n), 1e-3);
    EXPECT_LT(relative_error(sum.y_n, mean.y_n), 1e-3);
    EXPECT_LT(relative_error(sum.z_n, mean.z_n), 1e-3);
}

TEST(StrokeForces, RangeEnclosesEveryForceOfTheTurn)
{
    const MillingJob job = steel_job();
    const MilledMove move = milled(slot());
    const auto [least, greatest] = turn_range(move, job, 90);
    bool meets_greatest = false;
    for (const CuttingForce& force : turn_forces(move, job, 90)) {
        EXPECT_LE(least.x_n, force.x_n);
        EXPECT_LE(force.x_n, greatest.x_n);
        meets_greatest = meets_greatest || force.x_n == greatest.x_n;
    }
    EXPECT_TRUE(meets_greatest);
}

TEST(StrokeForces, InAirAreZero)
{
    SegmentCut air = slot();
    air.depth_mm = -1;
    const auto [least, greatest] = turn_range(milled(air), steel_job(), 12);
    EXPECT_EQ(least.x_n, 0);
    EXPECT_EQ(greatest.z_n, 0);
    EXPECT_EQ(peak_cutting_forces({milled(air)}, steel_job()), std::vector<double>{0});
}

// A horizontal slot of depth d removes the circular segment of height d along its length.
TEST(StrokeForces, OfASlotHaveItsVolumeAndTime)
{
    const MillingJob job = steel_job();
    const std::vector<MilledMove> moves{milled(slot()), milled(slot())};
    const std::vector<ForceRange> ranges{turn_range(moves[0], job, 36),
                                         turn_range(moves[1], job, 36)};
    const StrokeForces stroke = stroke_forces(moves, ranges, job);
    EXPECT_NEAR(stroke.minutes, 40 / (2 * 0.1 * 500), 1e-12);
    const double section = 25 * std::acos(4.0 / 5) - 4 * 3;
    EXPECT_LT(relative_error(stroke.removed_mm3, 40 * section), 1e-6);
    EXPECT_EQ(stroke.largest_downhill.x_n, 0) << "neither move falls";
}

TEST(StrokeForces, CountDownhillMovesByThemselves)
{
    const MillingJob job = steel_job();
    const std::vector<MilledMove> moves{milled(slot(0.3)), milled(slot(-0.3))};
    const std::vector<ForceRange> ranges{turn_range(moves[0], job, 36),
                                         turn_range(moves[1], job, 36)};
    const StrokeForces stroke = stroke_forces(moves, ranges, job);
    const auto& [least, greatest] = ranges[1];
    EXPECT_EQ(stroke.largest_downhill.z_n,
              std::max(std::abs(least.z_n), std::abs(greatest.z_n)));
    EXPECT_GE(stroke.largest.z_n, stroke.largest_downhill.z_n);
}

TEST(UsedLife, IsTheTimeDividedByTaylorsLife)
{
    const MillingJob job = steel_job();
    const std::vector<MilledMove> moves{milled(slot())};
    const double speed_m_per_min = 2 * std::numbers::pi * 5 * 500 / 1000;
    const double contact = tool_life_angle(ball_engagement(moves[0].cut, 5));
    const double c_b = job.material.v1_m_per_min * std::pow(240, job.material.alpha);
    const double life = std::pow(c_b / speed_m_per_min, 1 / job.material.alpha) /
                        (contact / std::numbers::pi);
    EXPECT_LT(relative_error(used_life(moves, job, 240), 0.2 / life), 1e-12);
}

TEST(PeakCuttingForces, AreThoseOfAFineTurn)
{
    const MillingJob job = steel_job();
    const MilledMove move = milled(slot());
    double largest = 0;
    double thrust = 0;
    for (const CuttingForce& force : turn_forces(move, job, 7200)) {
        largest = std::max(largest, std::hypot(force.x_n, force.y_n));
        thrust = std::max(thrust, force.z_n);
    }
    const double peak = peak_cutting_forces({move}, job).front();
    EXPECT_LT(relative_error(peak, largest), 1e-3);
    const CuttingLoads loads = peak_loads({move}, job).front();
    EXPECT_EQ(loads.cutting_force_n, peak);
    EXPECT_LT(relative_error(loads.thrust_n, thrust), 1e-3);
}

TEST(MilledMoves, HaveTheFeedsOfThePlanOrOne)
{
    const MillingJob job = steel_job();
    const std::vector<SegmentCut> cuts{slot(), slot(0.2)};
    const FeedPlan plan = feed_plan(cuts, job, {});
    const auto planned = milled_moves(cuts, plan, {});
    const auto constant = milled_moves(cuts, plan, 0.03);
    ASSERT_EQ(planned.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(planned[i].feed_per_tooth_mm, plan.rows[i].tooth.feed_per_tooth_mm);
        EXPECT_EQ(constant[i].feed_per_tooth_mm, 0.03);
        EXPECT_EQ(constant[i].spindle_rpm, plan.rows[i].table.spindle_rpm);
    }
    EXPECT_DOUBLE_EQ(constant_moves(cuts, 2, 100, 500)[0].feed_per_tooth_mm, 0.1);
}

}  // namespace
}  // namespace endmill
