// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/stock_patch.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/stock/detail/stock_probe.h"

namespace endmill {
namespace {

HeightStock wavy_stock(int columns, int rows)
{
    HeightStock stock{{-3, 2, 0.25, columns, rows, -5}, 0};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column)
            stock.set_height(column, row, std::sin(0.7 * column) * std::cos(1.1 * row));
    return stock;
}

// Compares all places of the disc up to the border of the reach.
void expect_same(const HeightStock& stock, const StockPatch& patch, const Vec3& place,
                 double reach)
{
    for (int k = 0; k < 400; ++k) {
        const double angle = 0.37 * k;
        const double radius = reach * (k % 4 == 0 ? 1 : std::sqrt(k / 400.0));
        const double x = place.x() + radius * std::cos(angle);
        const double y = place.y() + radius * std::sin(angle);
        ASSERT_EQ(interpolated_height(patch, x, y), interpolated_height(stock, x, y))
            << x << " " << y;
    }
}

TEST(StockPatch, CopiesTheStock)
{
    HeightStock stock = wavy_stock(61, 45);
    const HeightStock before = stock;
    StockPatch patch;
    // Inside the stock, over an edge, over a corner, and wholly beside it.
    for (const Vec3& place : {Vec3{4, 6, 0}, Vec3{-3, 7, 0}, Vec3{12.25, 13.25, 0},
                              Vec3{12.1, 2, 0}, Vec3{40, -30, 0}}) {
        patch.copy(before, place, 1.5);
        stock.set_height(28, 16, -4);
        expect_same(before, patch, place, 1.5);
    }
}

TEST(StockPatch, OfASmallStockIsAllOfIt)
{
    const HeightStock stock = wavy_stock(3, 1);
    StockPatch patch;
    patch.copy(stock, {-2.8, 2.1, 0}, 50);
    expect_same(stock, patch, {-2.8, 2.1, 0}, 1);
}

TEST(StockPatch, NeedsNoMoreMemoryThanStated)
{
    // Cells of 0.25 mm make tiles of 2 mm. The ball and its margin cover 3.5 mm, at most
    // 3 tiles of 512 bytes along x and y.
    EXPECT_GE(StockPatch::bytes(wavy_stock(9, 9).grid(), 1.25), 9 * 512);
}

}  // namespace
}  // namespace endmill
