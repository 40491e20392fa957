// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

PathPoint point(Move move, const Vec3& tip)
{
    return {0, 0, move, 0, {tip, Vec3::UnitZ()}};
}

TEST(PathLengths, SeparateMovesAtFeedFromOthers)
{
    const ToolPath path{{point(Move::Plunge, {100, 0, 0}), point(Move::Cut, {103, 4, 0}),
                         point(Move::Link, {103, 5, 0}), point(Move::Cut, {103, 5, 12}),
                         point(Move::Retract, {103, 5, 20}),
                         point(Move::Rapid, {106, 9, 20}),
                         point(Move::Plunge, {106, 9, 1})}};
    EXPECT_DOUBLE_EQ(path_lengths(path).at_feed_mm, 5 + 1 + 12);
    EXPECT_DOUBLE_EQ(path_lengths(path).lifted_mm, 8 + 5 + 19);
}

TEST(PathLengths, OfAnEmptyPathAreZero)
{
    EXPECT_EQ(path_lengths({}).at_feed_mm, 0);
    EXPECT_EQ(path_lengths({{point(Move::Plunge, {1, 2, 3})}}).lifted_mm, 0);
}

}  // namespace
}  // namespace endmill
