// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/body_place.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"
#include "test_meshes.h"

namespace endmill {
namespace {

// The maximum over many positions of the axis; it never exceeds the closed form.
double depth_by_positions(const BodyCylinder& body, const Vec3& from, const Vec3& to,
                          const Vec3& place, int positions)
{
    double depth = -1e9;
    for (int k = 0; k <= positions; ++k) {
        const Vec3 tip = from + k / double(positions) * (to - from);
        depth = std::max(depth, std::min(place.z() - tip.z() - body.above,
                                         body.radius - (place - tip).head<2>().norm()));
    }
    return depth;
}

TEST(PlaceInBody, IsTheDeepestOfAllPositions)
{
    test::Random random{1};
    const int positions = 2000;
    for (int run = 0; run < 300; ++run) {
        const BodyCylinder body{random.uniform(1, 8), random.uniform(0, 5)};
        const Vec3 from = test::random_point(random, 10);
        const Vec3 to = run % 5 == 0   ? from
                        : run % 5 == 1 ? Vec3{from.x(), from.y(), from.z() - 3}
                        : run % 5 == 2 ? Vec3{from.x() + 4, from.y() - 2, from.z()}
                                       : test::random_point(random, 10);
        const Vec3 place = test::random_point(random, 12);
        const double found = place_in_body(body, swept_move(from, to), place).depth;
        const double expected = depth_by_positions(body, from, to, place, positions);
        EXPECT_GE(found, expected - 1e-11) << run;
        EXPECT_LE(found, expected + (to - from).norm() / positions + 1e-11) << run;
    }
}

TEST(PlaceInBody, IsBelowItsTangent)
{
    test::Random random{2};
    for (int run = 0; run < 2000; ++run) {
        const BodyCylinder body{random.uniform(1, 8), random.uniform(0, 5)};
        const SweptMove move =
            swept_move(test::random_point(random, 10), test::random_point(random, 10));
        const Vec3 one = test::random_point(random, 12);
        const Vec3 other = one + test::random_point(random, 3);
        const BodyPlace at = place_in_body(body, move, one);
        const double there = place_in_body(body, move, other).depth;
        EXPECT_LE(there, at.depth + at.rise.dot(other - one) + 1e-11) << run;
        EXPECT_LE(std::abs(there - at.depth), (other - one).norm() + 1e-11) << run;
        EXPECT_LE(at.rise.norm(), 1 + 1e-12);
    }
}

// On the axis all horizontal ways out are equally long.
TEST(PlaceInBody, HasATangentOnTheAxis)
{
    const BodyPlace at =
        place_in_body({3, 10}, swept_move({0, 0, 0}, {0, 0, 0}), {0, 0, 20});
    EXPECT_EQ(at.depth, 3);
    EXPECT_EQ(at.rise, Vec3::Zero());
}

}  // namespace
}  // namespace endmill
