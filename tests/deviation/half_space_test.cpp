// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/half_space.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "random.h"

namespace endmill {
namespace {

Vec3 uniform(test::Random& random, double size)
{
    return {random.uniform(-size, size), random.uniform(-size, size),
            random.uniform(-size, size)};
}

// All points at and above the height of the sweep belong to the swept volume.
TEST(HalfSpace, ContainsTheVolumeOfTheSweep)
{
    test::Random random{51};
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}})
        for (int i = 0; i < 3000; ++i) {
            const Vec3 from = uniform(random, 5);
            const StraightSweep sweep{cutter, from, from + uniform(random, 6)};
            const HalfSpace half = half_space_beyond(sweep, uniform(random, 9));
            EXPECT_NEAR(half.normal.norm(), 1, 1e-12);
            EXPECT_GE(half.normal.z(), 0);
            for (int k = 0; k < 20; ++k) {
                Vec3 at = uniform(random, 12);
                at.z() = sweep.height(at.x(), at.y());
                if (std::isfinite(at.z())) {
                    EXPECT_GE(half.normal.dot(at), half.least - 1e-12);
                }
            }
        }
}

TEST(HalfSpace, OfALevelMoveTouchesIt)
{
    const StraightSweep ball{Cutter::ball(5), {0, 0, 0}, {20, 0, 0}};
    const Vec3 aside{10, -7, -3};
    const HalfSpace near = half_space_beyond(ball, aside);
    EXPECT_NEAR(near.least - near.normal.dot(aside), std::hypot(7, 8) - 5, 1e-13);
    const StraightSweep flat{Cutter::flat(5), {0, 0, 0}, {20, 0, 0}};
    const HalfSpace wall = half_space_beyond(flat, {10, -5, 2});  // a place on its side
    EXPECT_LT((wall.normal - Vec3::UnitY()).norm(), 1e-15);
    EXPECT_EQ(wall.least, -5);
    const HalfSpace floor = half_space_beyond(flat, {10, 1, 0});  // a place on its bottom
    EXPECT_EQ(floor.normal, Vec3(0, 0, 1));
    EXPECT_EQ(floor.least, 0);
}

}  // namespace
}  // namespace endmill
