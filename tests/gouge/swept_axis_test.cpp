// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/gouge/detail/swept_axis.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include "endmill/gouge/gouge_test.h"
#include "random.h"

namespace endmill {
namespace {

Vec3 random_vector(test::Random& random, double size)
{
    const double x = random.uniform(-size, size);
    const double y = random.uniform(-size, size);
    return {x, y, random.uniform(-size, size)};
}

// The distance of a point from the axis of the shank of a ball at `centre`, which is a
// ray.
double shank_distance(const Vec3& point, const Vec3& centre, const Vec3& axis)
{
    const double along = (point - centre).dot(axis);
    return along > 0 ? (point - centre - along * axis).norm() : (point - centre).norm();
}

TEST(SweptAxis, IsTheShanksOfAllBallsOfTheMove)
{
    test::Random random{7};
    constexpr int positions = 4000;
    for (int k = 0; k < 60; ++k) {
        const Vec3 axis = (Vec3{0, 0, 1.5} + random_vector(random, 1)).normalized();
        const BallMove move{random_vector(random, 9), random_vector(random, 9)};
        const Vec3 point = random_vector(random, 20);
        double expected = std::numeric_limits<double>::infinity();
        for (int i = 0; i <= positions; ++i) {
            const Vec3 centre = move.from + i / double(positions) * (move.to - move.from);
            expected = std::min(expected, shank_distance(point, centre, axis));
        }
        const double distance =
            (point - SweptAxis{move.from, move.to, axis}.nearest(point)).norm();
        EXPECT_LE(distance, expected + 1e-12);
        EXPECT_GT(distance, expected - (move.to - move.from).norm() / positions);
    }
}

// A direction that does not rise along the axis has its greatest product at the centre of
// a ball of the move.
TEST(SweptAxis, ReachesAlongADirectionAsFarAsACentreOrWithoutEnd)
{
    test::Random random{8};
    constexpr int positions = 100;
    for (int k = 0; k < 200; ++k) {
        const Vec3 axis = (Vec3{0, 0, 1.5} + random_vector(random, 1)).normalized();
        const Vec3 from = random_vector(random, 9);
        const Vec3 to = k % 4 == 0 ? Vec3{from + random.uniform(-9, 9) * axis}
                                   : random_vector(random, 9);
        const Vec3 direction = random_vector(random, 1).normalized();
        const double farthest = SweptAxis{from, to, axis}.farthest_along(direction);
        if (direction.dot(axis) > 0) {
            EXPECT_EQ(farthest, std::numeric_limits<double>::infinity());
            continue;
        }
        double expected = direction.dot(from);
        for (int i = 0; i <= positions; ++i)
            expected = std::max(
                expected, direction.dot(from + i / double(positions) * (to - from)));
        EXPECT_NEAR(farthest, expected, 1e-13);
    }
}

TEST(SweptAxis, HoldsItsOwnPoints)
{
    const SweptAxis swept{{0, 0, 0}, {10, 0, 5}, Vec3::UnitZ()};
    const Vec3 inside{4, 0, 9};
    EXPECT_LT((swept.nearest(inside) - inside).norm(), 1e-14);
    EXPECT_LT((swept.nearest({5, 3, 1}) - Vec3{4.4, 0, 2.2}).norm(), 1e-14);
}

TEST(SweptAxis, OfAMoveAlongTheAxisIsTheRayFromItsLowerEnd)
{
    for (const BallMove& move :
         {BallMove{{1, 2, 3}, {1, 2, 8}}, BallMove{{1, 2, 8}, {1, 2, 3}},
          BallMove{{1, 2, 3}, {1, 2, 3}}}) {
        const SweptAxis swept{move.from, move.to, Vec3::UnitZ()};
        EXPECT_LT((swept.nearest({5, 2, 7}) - Vec3{1, 2, 7}).norm(), 1e-14);
        EXPECT_LT((swept.nearest({1, 5, -1}) - Vec3{1, 2, 3}).norm(), 1e-14);
    }
}

}  // namespace
}  // namespace endmill
