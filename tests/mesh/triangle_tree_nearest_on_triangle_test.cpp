// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_tree.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

Vec3 somewhere(test::Random& random)
{
    return {random.uniform(-3, 3), random.uniform(-3, 3), random.uniform(-3, 3)};
}

// A point of a convex set is the nearest one if no other point of the set is further
// ahead in the direction of the place.
TEST(NearestOnTriangle, HasNoCornerBeyondItsTangentPlane)
{
    test::Random random{1};
    for (int i = 0; i < 2000; ++i) {
        const std::array<Vec3, 3> corners{somewhere(random), somewhere(random),
                                          somewhere(random)};
        const Vec3 place = somewhere(random);
        const Vec3 found = nearest_on_triangle(place, corners);
        for (const Vec3& corner : corners)
            EXPECT_LE((place - found).dot(corner - found), 1e-13);
    }
}

TEST(NearestOnTriangle, LiesOnIt)
{
    test::Random random{2};
    for (int i = 0; i < 500; ++i) {
        const std::array<Vec3, 3> corners{Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 3, 0}};
        const Vec3 found = nearest_on_triangle(somewhere(random), corners);
        EXPECT_NEAR(found.z(), 0, 1e-15);
        EXPECT_GE(std::min(found.x(), found.y()), -1e-15);
        EXPECT_LE(found.x() / 2 + found.y() / 3, 1 + 1e-15);
    }
}

TEST(NearestOnTriangle, OneWithoutAreaIsASegmentOrAPoint)
{
    const Vec3 a{0, 0, 0};
    const Vec3 b{2, 0, 0};
    EXPECT_EQ(nearest_on_triangle({1, 5, 0}, {a, b, b}), (Vec3{1, 0, 0}));
    EXPECT_EQ(nearest_on_triangle({9, 1, 0}, {a, a, b}), b);
    EXPECT_EQ(nearest_on_triangle({1, 1, 1}, {a, a, a}), a);
}

}  // namespace
}  // namespace endmill
