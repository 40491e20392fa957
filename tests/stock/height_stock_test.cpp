// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/height_stock.h"

#include <limits>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(GridOver, HasTheCellsThatTheBoxHolds)
{
    const StockGrid grid = grid_over({{-60, -40, -5}, {60, 40, 20}}, 0.1);
    EXPECT_EQ(grid.columns, 1200);
    EXPECT_EQ(grid.rows, 800);
    EXPECT_EQ(grid.bottom_z, -5);
    EXPECT_NEAR(grid.x(0), -59.95, 1e-12);
    EXPECT_NEAR(grid.y(799), 39.95, 1e-12);
}

TEST(GridOver, IsWidenedEvenlyToWholeCells)
{
    const StockGrid grid = grid_over({{0, 0, 0}, {10.5, 0.2, 1}}, 1);
    EXPECT_EQ(grid.columns, 11);
    EXPECT_EQ(grid.rows, 1);
    EXPECT_NEAR(grid.low_x, -0.25, 1e-15);
    EXPECT_NEAR(grid.low_y, -0.4, 1e-15);
}

TEST(GridOver, OfAPointIsACell)
{
    const StockGrid grid = grid_over({{3, 4, 5}, {3, 4, 5}}, 0.5);
    EXPECT_EQ(grid.columns, 1);
    EXPECT_EQ(grid.x(0), 3);
    EXPECT_EQ(grid.y(0), 4);
}

TEST(GridOver, RefusesInvalidBoxesAndPitches)
{
    const Block box{{0, 0, 0}, {1, 1, 1}};
    EXPECT_THROW(grid_over(box, 0), DomainError);
    EXPECT_THROW(grid_over(box, -1), DomainError);
    EXPECT_THROW(grid_over(box, std::nan("")), DomainError);
    EXPECT_THROW(grid_over({{0, 0, 0}, {1, -1, 1}}, 1), DomainError);
    EXPECT_THROW(grid_over({{0, 0, 0}, {infinite, 1, 1}}, 1), DomainError);
    EXPECT_THROW(grid_over({{0, 0, 0}, {1e6, 1, 1}}, 1e-6), LimitError);
}

TEST(HeightStock, ABlockHasItsVolume)
{
    const HeightStock stock = block_stock({{0, 0, -2}, {10, 5, 4}}, 0.25);
    EXPECT_NEAR(stock_volume(stock), 10 * 5 * 6, 1e-10);
    const auto range = height_range(stock);
    ASSERT_TRUE(range);
    EXPECT_EQ(range->low, 4);
    EXPECT_EQ(range->high, 4);
}

TEST(HeightStock, WithoutMaterialHasNoRange)
{
    const HeightStock stock = block_stock({{0, 0, 1}, {10, 5, 1}}, 1);
    EXPECT_EQ(stock_volume(stock), 0);
    EXPECT_FALSE(height_range(stock));
}

// Each cell of the grid has one place in the tiles, and the places beyond the grid stay
// at the bottom.
TEST(HeightStock, TilesHoldEveryCellOnce)
{
    const StockGrid grid{
        .low_x = 0, .low_y = 0, .pitch = 1, .columns = 19, .rows = 9, .bottom_z = -1};
    std::vector<double> heights;
    for (int k = 0; k < 19 * 9; ++k)
        heights.push_back(k);
    const HeightStock stock = stock_of_heights(grid, heights);
    ASSERT_EQ(stock.tile_columns(), 3);
    ASSERT_EQ(stock.tile_rows(), 2);
    std::set<double> found;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 64; ++k) {
                const int column = 8 * i + k % 8;
                const int row = 8 * j + k / 8;
                const double z = stock.tile(i, j)[k];
                if (column < 19 && row < 9) {
                    EXPECT_EQ(z, row * 19 + column);
                    EXPECT_EQ(z, stock.height(column, row));
                    found.insert(z);
                } else {
                    EXPECT_EQ(z, -1);
                }
            }
    EXPECT_EQ(found.size(), heights.size());
}

TEST(HeightStock, AHeightBelowTheBottomIsCutThrough)
{
    HeightStock stock = block_stock({{0, 0, 0}, {2, 1, 1}}, 1);
    stock.set_height(0, 0, -7);
    EXPECT_EQ(stock.height(0, 0), 0);
    EXPECT_NEAR(stock_volume(stock), 1, 1e-15);
}

TEST(HeightStock, RefusesHeightsThatAreNotOneACell)
{
    const StockGrid grid{
        .low_x = 0, .low_y = 0, .pitch = 1, .columns = 2, .rows = 2, .bottom_z = 0};
    EXPECT_THROW(stock_of_heights(grid, std::vector<double>(3, 1)), DomainError);
    EXPECT_THROW(stock_of_heights(grid, std::vector<double>{1, 1, 1, infinite}),
                 DomainError);
    StockGrid empty = grid;
    empty.columns = 0;
    EXPECT_THROW(HeightStock(empty, 1), DomainError);
    EXPECT_THROW(HeightStock(grid, std::nan("")), DomainError);
}

}  // namespace
}  // namespace endmill
