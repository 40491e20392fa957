// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/detail/line.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

namespace endmill {
namespace {

TEST(LineInterval, HasIntersectionAndHull)
{
    EXPECT_EQ(intersection({0, 2}, {1, 5}).low, 1);
    EXPECT_EQ(intersection({0, 2}, {1, 5}).high, 2);
    EXPECT_TRUE(intersection({0, 1}, {2, 3}).is_empty());
    EXPECT_EQ(hull({0, 1}, {2, 3}).high, 3);
    EXPECT_EQ(hull(LineInterval::none(), {2, 3}).low, 2);
    EXPECT_EQ(hull({2, 3}, LineInterval::none()).low, 2);
}

TEST(WhereNotNegative, IsAHalfLineTheWholeLineOrEmpty)
{
    EXPECT_EQ(where_not_negative(-6, 2).low, 3);
    EXPECT_EQ(where_not_negative(6, -2).high, 3);
    EXPECT_FALSE(where_not_negative(0, 0).is_empty());
    EXPECT_TRUE(where_not_negative(-1, 0).is_empty());
}

TEST(WithinCircle, IsAChord)
{
    const LineInterval chord = within_circle({-10, 3}, {2, 0}, 5);
    EXPECT_EQ(chord.low, 3);
    EXPECT_EQ(chord.high, 7);
    EXPECT_TRUE(within_circle({-10, 5.1}, {2, 0}, 5).is_empty());
    EXPECT_FALSE(within_circle({3, 4}, {0, 0}, 5).is_empty());
    EXPECT_TRUE(within_circle({3, 4.1}, {0, 0}, 5).is_empty());
}

const StraightSweep oblique{Cutter::ball(5), {1, 2, 3}, {4, 6, 5}};
const Line line{{2, 1, 9}, Vec3{2, -1, 2} / 3};

TEST(LineInPlan, HasTheSameVectorsInTheMovesFrame)
{
    const LineInPlan plan = line_in_plan(oblique, line);
    EXPECT_EQ(plan.length, 5);
    EXPECT_EQ(plan.rise, 2);
    const Vec3 back = out_of_plan(plan, plan.start.x(), plan.start.y(), plan.start_z);
    EXPECT_LT((back - (line.origin - oblique.from())).norm(), 1e-14);
    const Vec3 rate = out_of_plan(plan, plan.rate.x(), plan.rate.y(), plan.rate_z);
    EXPECT_LT((rate - line.direction).norm(), 1e-15);
}

TEST(WithinOutline, EndsOnTheRimAndItsNormalPointsOut)
{
    const LineInPlan plan = line_in_plan(oblique, line);
    const LineInterval within = within_outline(plan, 5);
    ASSERT_FALSE(within.is_empty());
    for (const double t : {within.low, within.high}) {
        const Vec3 at = line.origin + t * line.direction;
        const Vec3 normal = outline_normal(plan, t);
        EXPECT_NEAR(normal.norm(), 1, 1e-14);
        // The point one radius inwards is on the move.
        const Eigen::Vector2d on_move = (at - 5 * normal - oblique.from()).head<2>();
        const Eigen::Vector2d along{0.6, 0.8};
        EXPECT_NEAR(on_move.x() * along.y() - on_move.y() * along.x(), 0, 1e-12);
        EXPECT_GE(on_move.dot(along), -1e-12);
        EXPECT_LE(on_move.dot(along), 5 + 1e-12);
    }
}

}  // namespace
}  // namespace endmill
