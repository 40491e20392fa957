// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/group_removal.h"

#include <vector>

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

TEST(SweepingTool, ReachesAsFarAsItsWidestCylinder)
{
    EXPECT_EQ(sweeping_tool(Cutter::ball(5), {}).reach, 5);
    const std::vector<ToolCylinder> body{{.diameter = 8, .from = 10, .to = 40},
                                         {.diameter = 30, .from = 40, .to = 60}};
    const SweepingTool tool = sweeping_tool(Cutter::ball(5), body);
    EXPECT_EQ(tool.reach, 15);
    ASSERT_EQ(tool.body.size(), 2U);
    // Cylinders are narrowed, so that rounding at the rim does not count.
    EXPECT_NEAR(tool.body[1].radius, 15, 2e-8);
    EXPECT_LT(tool.body[1].radius, 15);
    EXPECT_EQ(tool.body[1].above, 40);
}

// Reference: every cell and every move in order, without tiles, groups and bounds.
TEST(RemovePart, IsTheLeastOfAllMovesInOrder)
{
    for (const Cutter& cutter : {Cutter::ball(3), Cutter::flat(3), Cutter{3, 1}}) {
        HeightStock stock = block_stock({{-9, -6, -3}, {9, 6, 2}}, 0.3);
        const HeightStock before = stock;
        std::vector<test::SmallMove> moves = test::small_moves(11, 120);
        std::vector<SweptMove> swept;
        for (const test::SmallMove& move : moves)
            swept.push_back(move.swept());
        const SweepingTool tool = sweeping_tool(cutter, {});
        const MoveBins bins{stock.grid(), swept, tool.reach, 1'000'000};
        constexpr double unit = 0x1p-50;
        const PartOfRemoval part = remove_part(stock, swept, bins, tool, unit);

        std::vector<double> removed(moves.size(), 0);
        for (int row = 0; row < stock.grid().rows; ++row)
            for (int column = 0; column < stock.grid().columns; ++column) {
                const double x = stock.grid().x(column);
                const double y = stock.grid().y(row);
                double height = before.height(column, row);
                for (std::size_t k = 0; k < moves.size(); ++k) {
                    const double after = std::max(
                        -3.0,
                        std::min(height,
                                 StraightSweep{cutter, moves[k].from, moves[k].to}.height(
                                     x, y)));
                    removed[k] += (height - after) * 0.3 * 0.3;
                    height = after;
                }
                EXPECT_NEAR(stock.height(column, row), height, 1e-11);
            }
        for (std::size_t k = 0; k < moves.size(); ++k)
            EXPECT_NEAR(static_cast<double>(part.volumes[k]) * unit, removed[k], 1e-9);
    }
}

}  // namespace
}  // namespace endmill
