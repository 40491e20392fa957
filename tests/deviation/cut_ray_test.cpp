// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/cut_ray.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(CutRay, IgnoresRemovalOnAnotherSideOfThePart)
{
    const StraightSweep beyond{Cutter::ball(5), {-20, 0, -9}, {-20, 0, -9}};
    const PartRay wall{{0, 0, 0}, Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()};
    EXPECT_FALSE(cut_ray(beyond, wall));
    const StraightSweep through{Cutter::ball(5), {-4, 0, -9}, {-4, 0, -9}};
    ASSERT_TRUE(cut_ray(through, wall));
    EXPECT_NEAR(cut_ray(through, wall)->thickness, -9, 1e-12);
}

// The cutter's side is one radius away from an upright wall.
TEST(CutRay, LeavesNothingWhereASideTouches)
{
    const PartRay wall{{0.1, 0, 2}, Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()};
    for (const double radius : {0.3, 1.7, 4.9}) {
        const double at = 0.1 + radius;
        const StraightSweep sweep{Cutter::flat(radius), {at, -9, 0}, {at, 9, 0}};
        const auto left = cut_ray(sweep, wall, 3);
        ASSERT_TRUE(left);
        EXPECT_NEAR(left->thickness, 0, 1e-12);
        EXPECT_FALSE(cut_ray(sweep, wall, 0));
    }
    const StraightSweep beyond{Cutter::flat(1), {-0.91, -9, 0}, {-0.91, 9, 0}};
    EXPECT_FALSE(cut_ray(beyond, wall, 3));
}

// A ball touches a plane. At a distance of 3 beside the contact, 5 - 4 of the vertical
// ray remains, and the slope of the ball is 3/4.
TEST(CutRay, HasTheSlopeOfTheRemainingStock)
{
    const StraightSweep sweep{Cutter::ball(5), {3, 0, 0}, {3, 0, 0}};
    const PartRay ray{Vec3::Zero(), Vec3::UnitZ(), Vec3::Zero(), Vec3::Zero()};
    const auto left = cut_ray(sweep, ray);
    ASSERT_TRUE(left);
    EXPECT_NEAR(left->thickness, 1, 1e-12);
    EXPECT_NEAR(left->slope, 0.75, 1e-12);
}

TEST(SlopeOfCosine, IsTheTangent)
{
    EXPECT_NEAR(slope_of_cosine(-0.8), 0.75, 1e-12);
    EXPECT_EQ(slope_of_cosine(1), 0);
    EXPECT_TRUE(std::isinf(slope_of_cosine(0)));
}

}  // namespace
}  // namespace endmill
