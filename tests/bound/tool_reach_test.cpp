// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/tool_reach.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// The distance from the half-line by sampling of its points.
double sampled_distance(const Vec3& centre, const Vec3& point)
{
    double least = (point - centre).norm();
    for (double s = 0; s < 20; s += 1e-3)
        least = std::min(least, (point - centre - s * Vec3::UnitZ()).norm());
    return least;
}

TEST(ToolReach, MeasuresFromTheHalfLineUpwards)
{
    test::Random random{1};
    const BoundProblem problem{BallCutter{3}, 0.1, 0.2};
    const Vec3 centre{1, -2, 3};
    const ToolReach tool{problem, centre};
    EXPECT_EQ(tool.reach(), 3.2);
    for (int k = 0; k < 200; ++k) {
        const double x = random.uniform(-8, 8);
        const double y = random.uniform(-8, 8);
        const Vec3 point{x, y, random.uniform(-8, 8)};
        const double distance = sampled_distance(centre, point);
        EXPECT_NEAR(tool.excess(point), distance - 3.2, 1e-3);
        EXPECT_NEAR(tool.from_nearest(point).norm(), distance, 1e-3);
    }
}

TEST(ToolReach, OfTheBallIsTheDistanceFromTheCentre)
{
    BoundProblem problem{BallCutter{3}, 0.1};
    problem.tool = CoveringTool::Ball;
    const ToolReach tool{problem, Vec3::Zero()};
    EXPECT_EQ(tool.excess({0, 0, 10}), 7);
    problem.tool = CoveringTool::BallAndFlank;
    EXPECT_EQ((ToolReach{problem, Vec3::Zero()}.excess({0, 1, 10})), -2);
}

}  // namespace
}  // namespace endmill
