// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/extreme_points.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "random.h"
#include "random_maps.h"

namespace endmill {
namespace {

double farthest(const std::vector<Vec3>& points, const Vec3& direction)
{
    double most = -1e300;
    for (const Vec3& point : points)
        most = std::max(most, point.dot(direction));
    return most;
}

// Points of a ball, of a plane, of a line, and all equal.
TEST(ExtremePoints, ReachAsFarAsAllPointsInEveryDirection)
{
    test::Random random{5};
    for (const Vec3& size :
         {Vec3{3, 2, 1}, Vec3{3, 2, 0}, Vec3{3, 0, 0}, Vec3{0, 0, 0}}) {
        std::vector<Vec3> points;
        for (int i = 0; i < 400; ++i)
            points.push_back(size.cwiseProduct(test::random_direction(random)) *
                             random.uniform(0, 1));
        const std::vector<Vec3> extreme = extreme_points(points);
        EXPECT_LT(extreme.size(), points.size());
        for (int i = 0; i < 100; ++i) {
            const Vec3 direction = test::random_direction(random);
            EXPECT_EQ(farthest(extreme, direction), farthest(points, direction));
        }
    }
}

TEST(ExtremePoints, LeaveAFewPointsAsTheyAre)
{
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0.5, 0, 0}};
    EXPECT_EQ(extreme_points(points), points);
    EXPECT_TRUE(extreme_points({}).empty());
}

}  // namespace
}  // namespace endmill
