// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tile_measure.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/stock/stock_history.h"
#include "test_meshes.h"
#include "test_surfaces.h"
#include "tip_path.h"

namespace endmill {
namespace {

const DeviationLimits limits{0.01, 0.1};

TEST(RefinementThresholds, IsNeverAboveTheLimitsWhileTheyHold)
{
    const RefinementThresholds early = refinement_thresholds(0.02, 0, limits);
    EXPECT_GT(early.upper, 0.02);
    EXPECT_LT(early.upper, limits.scallop);
    const RefinementThresholds near = refinement_thresholds(0.0999, 0.0099, limits);
    EXPECT_EQ(near.upper, limits.scallop + verdict_slack);
    EXPECT_EQ(near.lower, -limits.tolerance - verdict_slack);
    EXPECT_TRUE(near.are_exceeded(0.1011, 0));
    EXPECT_FALSE(near.are_exceeded(0.1009, -0.0109));
    EXPECT_TRUE(near.are_exceeded(0, -0.0111));
}

TEST(Extremes, OfAMergeAreThoseOfBothAndTheFirstOfEqualOnes)
{
    Extremes a;
    a.highest.left = 1;
    a.highest.chart = 7;
    a.bound(1.5, 0.5);
    Extremes b;
    b.highest.left = 1;
    b.deepest.left = -2;
    b.bound(-1, -3);
    a.merge(b);
    EXPECT_EQ(a.highest.chart, 7U);
    EXPECT_EQ(a.deepest.left, -2);
    EXPECT_EQ(a.upper, 1.5);
    EXPECT_EQ(a.lower, -3);
}

// One ball stands over the middle of a plane. The refined bounds approach the closed
// form.
TEST(TileMeasure, RefinedIsNearerToTheTruth)
{
    const Part part = std::vector<Surface>{test::plane(4, 4)};
    const PartCharts charts = part_charts(part);
    const std::vector<StraightSweep> sweeps =
        path_sweeps(test::tip_path({{2, 2, 0}}), Cutter::ball(5));
    const SweepTree tree{sweeps};
    DeviationOptions options;
    const InitialRay initial_ray = [](const PartRay&) { return CutRay{3, 0, -1}; };
    options.limits = {0.01, 1};
    const PartDistance distance{charts, 0.01};
    const Measured measured{charts, tree, initial_ray, options, distance};
    PartTile tile{charts.whole(0), 4, 4, 0};
    for (Eigen::Vector2d& at : tile.whole.at)  // 2 by 2 mm, away from the border
        at = Eigen::Vector2d{0.5, 0.5} + (at - Eigen::Vector2d{0.5, 0.5}) / 2;
    TileMeasure coarse{measured, tile};
    const Extremes rough = coarse.extremes();
    const Extremes fine = coarse.refined(refinement_thresholds(0, 0, limits), {0, 0});
    const double truth = 5 - std::sqrt(25 - 2.0);  // in the tile's corners
    for (const Extremes& found : {rough, fine}) {
        EXPECT_LE(found.highest.left, truth + 1e-12);
        EXPECT_GE(found.upper, truth - 1e-12);
        EXPECT_LE(found.lower, 0);
    }
    EXPECT_GT(fine.highest.left, rough.highest.left);
    EXPECT_GT(fine.rays, rough.rays);
}

// Near the upper edge of a block, the top is nearer to a point deep in the wall than the
// wall is.
TEST(LimitedThickness, KeepsItsSign)
{
    const Part part = test::box_mesh({0, 0, 0}, {4, 4, 4});
    const PartCharts charts = part_charts(part);
    const PartDistance distance{charts, 0.01};
    std::optional<std::size_t> hint;
    const PartRay wall{{0, 2, 3.8}, -Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()};
    EXPECT_NEAR(limited_thickness(-0.5, wall, distance, hint), -0.2, 1e-9);
    EXPECT_EQ(limited_thickness(-0.1, wall, distance, hint), -0.1);
    EXPECT_EQ(limited_thickness(0.5, wall, distance, hint), 0.5);
}

TEST(Extremes, OfCellsMeasuredTwiceKeepTheLargerArea)
{
    Extremes a;
    a.add_area(-0.02, 3, limits);
    a.add_area(0.2, 1, limits);
    a.add_area(0, 50, limits);
    Extremes b;
    b.add_area(-0.02, 2, limits);
    b.add_area(0.2, 4, limits);
    Extremes joined = a;
    joined.join(b);
    EXPECT_EQ(joined.gouge_area, 3);
    EXPECT_EQ(joined.uncut_area, 4);
    a.merge(b);
    EXPECT_EQ(a.gouge_area, 5);
    EXPECT_EQ(a.uncut_area, 5);
}

}  // namespace
}  // namespace endmill
