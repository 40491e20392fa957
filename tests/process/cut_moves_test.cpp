// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/detail/cut_moves.h"

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

PathPoint at(Move move, const Vec3& tip)
{
    return {3, 0, move, 0, {tip, Vec3::UnitZ()}};
}

TEST(CutMoves, AreTheCutsWithHorizontalMotionInPathOrder)
{
    const ToolPath path{{at(Move::Rapid, {0, 0, 5}), at(Move::Plunge, {0, 0, 0}),
                         at(Move::Cut, {3, 4, 0}), at(Move::Cut, {3, 4, 0}),
                         at(Move::Cut, {3, 4, -2}), at(Move::Cut, {3, 4, 1}),
                         at(Move::Link, {3, 5, 1}), at(Move::Cut, {5, 5, 1})}};
    const std::vector<CutMove> moves = cut_moves(path);
    ASSERT_EQ(moves.size(), 2u);
    EXPECT_EQ(moves[0].point, 2u);
    EXPECT_EQ(moves[0].pass(), 3);
    EXPECT_DOUBLE_EQ(moves[0].length_mm, 5);
    EXPECT_DOUBLE_EQ(moves[0].begin_mm, 5);
    EXPECT_EQ(moves[0].middle(), (Vec3{1.5, 2, 0}));
    EXPECT_LT((moves[0].direction() - Vec3{0.6, 0.8, 0}).norm(), 1e-15);
    EXPECT_EQ(moves[1].point, 7u);
    EXPECT_DOUBLE_EQ(moves[1].middle_mm(), 5 + 5 + 2 + 3 + 1 + 1);
}

TEST(CutMoves, OfAPathWithoutAMoveAreNone)
{
    EXPECT_TRUE(cut_moves({}).empty());
    EXPECT_TRUE(cut_moves({{at(Move::Cut, {0, 0, 0})}}).empty());
}

TEST(CutMoves, NeedAnUprightAxis)
{
    ToolPath path{{at(Move::Rapid, {0, 0, 0}), at(Move::Cut, {1, 0, 0})}};
    path.points[1].location.axis = Vec3{0, 0.01, 1}.normalized();
    EXPECT_THROW(cut_moves(path), GeometryError);
}

TEST(CutMoves, OfZeroLengthAreCounted)
{
    ToolPath path;
    for (const double x : {0.0, 0.0, 5.0, 5.0, 5.0, 9.0})
        path.points.push_back({0,
                               static_cast<int>(path.points.size()),
                               Move::Cut,
                               0,
                               {{x, 0, 0}, Vec3::UnitZ()}});
    path.points.back().move = Move::Rapid;
    EXPECT_EQ(zero_length_cuts(path), 3U);
    EXPECT_EQ(cut_moves(path).size(), 1U);
    EXPECT_EQ(zero_length_cuts({}), 0U);
}

}  // namespace
}  // namespace endmill
