// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

PathPoint point(Move move, const Vec3& tip, std::optional<double> feed = {},
                std::optional<int> tool = {})
{
    return {0, 0, move, 0, {tip, Vec3::UnitZ()}, {}, {feed, {}, tool}};
}

// Every move is the hypotenuse of a right triangle with whole sides.
TEST(PathTotals, CountEveryMoveOnce)
{
    const ToolPath path{
        {point(Move::Rapid, {100, 0, 20}), point(Move::Plunge, {100, 0, 0}, 40),
         point(Move::Cut, {103, 4, 0}, 100), point(Move::Link, {103, 5, 0}, 100),
         point(Move::Cut, {103, 10, 12}, 130), point(Move::Retract, {103, 10, 20}, 80),
         point(Move::Rapid, {106, 14, 20})}};
    const PathTotals totals = path_totals(path);
    EXPECT_DOUBLE_EQ(totals.cut_mm, 5 + 13);
    EXPECT_DOUBLE_EQ(totals.plunge_mm, 20);
    EXPECT_DOUBLE_EQ(totals.link_mm, 1 + 8);
    EXPECT_DOUBLE_EQ(totals.rapid_mm, 5);
    EXPECT_DOUBLE_EQ(totals.time_min.value(), 0.5 + 0.05 + 0.01 + 0.1 + 0.1);
    EXPECT_DOUBLE_EQ(totals.plunge_time_min, 0.5);
    EXPECT_EQ(totals.extent->low, Vec3(100, 0, 0));
    EXPECT_EQ(totals.extent->high, Vec3(106, 14, 20));
}

TEST(PathTotals, HaveNoTimeWithoutTheFeedOfAMove)
{
    ToolPath path{{point(Move::Rapid, {0, 0, 0}), point(Move::Cut, {1, 0, 0}, 100),
                   point(Move::Cut, {2, 0, 0})}};
    EXPECT_FALSE(path_totals(path).time_min);
    path.points[2].location.tip = path.points[1].location.tip;
    EXPECT_DOUBLE_EQ(path_totals(path).time_min.value(), 0.01);
}

TEST(PathTotals, OfRapidsHaveNoTime)
{
    const ToolPath path{{point(Move::Rapid, {0, 0, 0}), point(Move::Rapid, {3, 4, 0})}};
    EXPECT_FALSE(path_totals(path).time_min);
    EXPECT_EQ(path_totals(path).rapid_mm, 5);
}

TEST(PathTotals, NameEachToolOnce)
{
    const ToolPath path{
        {point(Move::Cut, {0, 0, 0}, 1, 12), point(Move::Cut, {1, 0, 0}, 1, 3),
         point(Move::Cut, {2, 0, 0}, 1, 12), point(Move::Cut, {3, 0, 0})}};
    EXPECT_EQ(path_totals(path).tools, (std::vector{3, 12}));
}

TEST(PathTotals, OfAnEmptyPathAreZero)
{
    const PathTotals totals = path_totals({});
    EXPECT_EQ(totals.cut_mm + totals.plunge_mm + totals.link_mm + totals.rapid_mm, 0);
    EXPECT_FALSE(totals.extent);
    EXPECT_FALSE(totals.time_min);
    EXPECT_TRUE(totals.tools.empty());
}

}  // namespace
}  // namespace endmill
