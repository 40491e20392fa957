// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/reached_share.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Vec2 = Eigen::Vector2d;
using Corners = std::array<Vec3, 3>;

double distance(const Vec2& place, const Vec2& a, const Vec2& b)
{
    const Vec2 along = b - a;
    const double length2 = along.squaredNorm();
    const double share =
        length2 > 0 ? std::clamp((place - a).dot(along) / length2, 0.0, 1.0) : 0;
    return (place - a - share * along).norm();
}

// The distance in plan from a triangle: 0 inside, where the three angles of the corners make a
// full turn.
double distance(const Vec2& place, const Corners& corners)
{
    double least = std::numeric_limits<double>::infinity();
    double turn = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec2 a = corners[k].head<2>();
        const Vec2 b = corners[(k + 1) % 3].head<2>();
        least = std::min(least, distance(place, a, b));
        const Vec2 p = a - place;
        const Vec2 q = b - place;
        turn += std::atan2(p.x() * q.y() - p.y() * q.x(), p.dot(q));
    }
    return std::abs(turn) > 3 ? 0 : least;
}

TEST(ReachedShare, AgreesWithTheDistanceAtManyPlaces)
{
    test::Random random{11};
    int reached_moves = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const double size = random.log_uniform(0.05, 10);
        Corners corners;
        for (Vec3& corner : corners)
            corner = {random.uniform(-size, size), random.uniform(-size, size),
                      random.uniform(-9, 9)};
        const double radius = random.log_uniform(0.1, 3);
        const Vec2 from{random.uniform(-6, 6), random.uniform(-6, 6)};
        const Vec2 to =
            trial % 10 == 0 ? from : Vec2{random.uniform(-6, 6), random.uniform(-6, 6)};
        const auto reached = reached_share(corners, from, to, radius);
        reached_moves += reached.has_value();
        for (int k = 0; k <= 64; ++k) {
            const double share = k / 64.0;
            const double away = distance(from + share * (to - from), corners);
            const bool is_inside =
                reached && reached->first <= share && share <= reached->second;
            if (std::abs(away - radius) > 1e-7) {
                EXPECT_EQ(is_inside, away < radius) << trial << ' ' << share;
            }
        }
    }
    EXPECT_GT(reached_moves, 500);
}

TEST(ReachedShare, EndsWhereADiscTouchesASide)
{
    const Corners corners{Vec3{0, -50, 0}, Vec3{100, 0, 7}, Vec3{0, 50, -3}};
    const auto reached = reached_share(corners, {-10, 0}, {10, 0}, 2);
    ASSERT_TRUE(reached.has_value());
    EXPECT_NEAR(reached->first, 0.4, 1e-8);
    EXPECT_EQ(reached->second, 1);
    EXPECT_FALSE(reached_share(corners, {-10, 0}, {-3, 0}, 2).has_value());
    // A triangle without area, seen from above: a wall.
    const Corners wall{Vec3{0, -5, 0}, Vec3{0, 5, 0}, Vec3{0, 5, 20}};
    const auto across = reached_share(wall, {-4, 1}, {4, 1}, 1);
    ASSERT_TRUE(across.has_value());
    EXPECT_NEAR(across->first, 3.0 / 8, 1e-8);
    EXPECT_NEAR(across->second, 5.0 / 8, 1e-8);
}

}  // namespace
}  // namespace endmill
