// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/indexed_path.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

ClearBall ball_of(double radius)
{
    return {{1, 2, 3}, radius};
}

// A plunge and a cut of one pass with an axis, near the centre of the ball.
IndexedStretch stretch(const Vec3& axis, int first_pass = 0)
{
    ToolPath path;
    const Vec3 side = axis.unitOrthogonal();
    for (int k = 0; k < 3; ++k)
        path.points.push_back({first_pass + (k == 2 ? 1 : 0),
                               k == 2 ? 0 : k,
                               k == 0 ? Move::Plunge : Move::Cut,
                               0,
                               {Vec3{1, 2, 3} + (2.0 * k) * side, axis}});
    return {path, 8 + Vec3{1, 2, 3}.dot(axis)};
}

// The point at a share of a move, with straight tips and the great arc of axes.
CutterLocation between(const PathPoint& from, const PathPoint& to, double share)
{
    const Vec3& a = from.location.axis;
    const Vec3& b = to.location.axis;
    const double turn = std::atan2(a.cross(b).norm(), a.dot(b));
    const Vec3 axis =
        turn < 1e-9
            ? b
            : Vec3{(std::sin((1 - share) * turn) * a + std::sin(share * turn) * b) /
                   std::sin(turn)};
    return {(1 - share) * from.location.tip + share * to.location.tip, axis};
}

class IndexedTurn : public testing::TestWithParam<Vec3> {};

TEST_P(IndexedTurn, KeepsTheToolOutsideTheBall)
{
    const Vec3 to = GetParam().normalized();
    const ClearBall ball = ball_of(20);
    const ToolPath path =
        indexed_path(std::vector{stretch(Vec3::UnitZ()), stretch(to)}, ball);
    double least = 1e9;
    double most_turn = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& a = path.points[k - 1];
        const PathPoint& b = path.points[k];
        const double turn =
            std::acos(std::min(1.0, a.location.axis.dot(b.location.axis)));
        most_turn = std::max(most_turn, turn * 180 / std::numbers::pi);
        if (turn < 1e-7)
            continue;
        EXPECT_EQ(b.move, Move::Rapid);
        for (int step = 0; step <= 50; ++step) {
            const CutterLocation at = between(a, b, step / 50.0);
            // the whole tool is above the plane through its tip
            least = std::min(least, (at.tip - ball.centre).dot(at.axis));
        }
    }
    EXPECT_GE(least, ball.radius * (1 - 1e-12));
    EXPECT_LE(most_turn, turning_step_deg * (1 + 1e-6));
    EXPECT_EQ(path.points.back().location.axis, to);
}

INSTANTIATE_TEST_SUITE_P(Axes, IndexedTurn,
                         testing::Values(Vec3{1, 1, 1}, Vec3{-1, 0, 1e-3}, Vec3{0, 0, -1},
                                         Vec3{0.01, 0, 1}, Vec3{1e-9, 0, -1}));

TEST(IndexedPath, RaisesAndLowersTheToolAlongItsAxis)
{
    const Vec3 to = Vec3{1, 0, 0};
    const ToolPath path =
        indexed_path(std::vector{stretch(Vec3::UnitZ(), 3), stretch(to)}, ball_of(20));
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& a = path.points[k - 1];
        const PathPoint& b = path.points[k];
        const Vec3 way = b.location.tip - a.location.tip;
        if (b.move == Move::Retract || b.move == Move::Plunge) {
            EXPECT_LT(way.cross(b.location.axis).norm(), 1e-12);
        }
        if (b.move == Move::Rapid) {  // never below the safe height of its stretch
            const double height = b.location.tip.dot(b.location.axis);
            EXPECT_GE(height, stretch(b.location.axis).safe_height - 1e-12);
        }
    }
    // passes 3 and 4 become 0 and 1, the second path has 2 and 3
    EXPECT_EQ(path.points.front().pass, 0);
    EXPECT_EQ(path.points.back().pass, 3);
    const auto plunges = std::ranges::count(path.points, Move::Plunge, &PathPoint::move);
    EXPECT_EQ(plunges, 2);
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const bool is_new = path.points[k].pass != path.points[k - 1].pass;
        EXPECT_EQ(path.points[k].point, is_new ? 0 : path.points[k - 1].point + 1);
    }
}

TEST(IndexedPath, OfOneStretchIsThisStretchAndALift)
{
    const IndexedStretch one = stretch(Vec3{0, 0.6, 0.8});
    const ToolPath path = indexed_path(std::vector{one}, ball_of(5));
    ASSERT_EQ(path.points.size(), one.path.points.size() + 1);
    for (std::size_t k = 0; k < one.path.points.size(); ++k)
        EXPECT_EQ(path.points[k].location.tip, one.path.points[k].location.tip);
    const PathPoint& end = path.points.back();
    EXPECT_EQ(end.move, Move::Retract);
    EXPECT_EQ(end.location.axis, (Vec3{0, 0.6, 0.8}));
    EXPECT_NEAR(end.location.tip.dot(end.location.axis), one.safe_height, 1e-12);
    const Vec3 way = end.location.tip - one.path.points.back().location.tip;
    EXPECT_LT(way.cross(end.location.axis).norm(), 1e-12);
    EXPECT_TRUE(indexed_path({}, ball_of(5)).points.empty());
}

TEST(IndexedPath, RefusesWhatItCannotJoin)
{
    IndexedStretch low = stretch(Vec3::UnitZ());
    low.safe_height = 0;
    EXPECT_THROW(indexed_path(std::vector{low}, ball_of(5)), GeometryError);
    IndexedStretch turning = stretch(Vec3::UnitZ());
    turning.path.points.back().location.axis = Vec3::UnitX();
    EXPECT_THROW(indexed_path(std::vector{turning}, ball_of(5)), DomainError);
    EXPECT_THROW(indexed_path(std::vector{IndexedStretch{{}, 5}}, ball_of(5)),
                 DomainError);
    EXPECT_THROW(indexed_path(std::vector{stretch(Vec3::UnitZ())}, ball_of(0)),
                 DomainError);
}

}  // namespace
}  // namespace endmill
