// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/stock_probe.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(StockProbe, IsLinearBetweenTheCentresOfCells)
{
    HeightStock stock = block_stock({{0, 0, 0}, {4, 4, 0}}, 1);
    const auto plane = [](double x, double y) { return 5 + 0.5 * x - 0.25 * y; };
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            stock.set_height(column, row, plane(column + 0.5, row + 0.5));
    for (const double x : {0.5, 1.3, 2.0, 3.5})
        for (const double y : {0.5, 0.9, 3.1, 3.5})
            EXPECT_NEAR(interpolated_height(stock, x, y).value(), plane(x, y), 1e-14);
    // Between the outermost centres and the border the height is that of the centres.
    EXPECT_NEAR(interpolated_height(stock, 0, 2).value(), plane(0.5, 2), 1e-14);
}

TEST(StockProbe, IsEmptyBesideTheStock)
{
    const HeightStock stock = block_stock({{0, 0, 0}, {4, 4, 1}}, 1);
    EXPECT_FALSE(interpolated_height(stock, -0.1, 2));
    EXPECT_FALSE(interpolated_height(stock, 2, 4.1));
    EXPECT_FALSE(interpolated_height(stock, std::nan(""), 2));
}

TEST(StockProbe, TakesTheBallsGroove)
{
    HeightStock stock = block_stock({{-10, -10, -10}, {10, 10, 0}}, 0.5);
    remove_swept(stock, Cutter::ball(5), swept_move({-20, 0, -3}, {20, 0, -3}));
    const double y = 1.25;  // the centre of a cell
    EXPECT_NEAR(interpolated_height(stock, 0.25, y).value(), 2 - std::sqrt(25 - y * y),
                1e-12);
    EXPECT_EQ(interpolated_height(stock, 0.25, 7.25).value(), 0);
}

}  // namespace
}  // namespace endmill
