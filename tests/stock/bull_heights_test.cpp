// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/bull_heights.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

class BullHeightsOf : public testing::TestWithParam<Cutter> {};

TEST_P(BullHeightsOf, AreThoseOfTheSweep)
{
    const Cutter cutter = GetParam();
    const TilePlace place = test::small_tile();
    TileHeights high;
    high.fill(1e6);
    for (const test::SmallMove& move : test::small_moves(3, 700)) {
        const StraightSweep sweep{cutter, move.from, move.to};
        TileHeights heights;
        bull_heights(high, place, cutter, move.swept(), heights);
        for (int k = 0; k < 64; ++k)
            EXPECT_TRUE(
                test::is_height(sweep, place.x[k % 8], place.y[k / 8], heights[k]))
                << move.from.transpose() << " to " << move.to.transpose() << " cell "
                << k;
    }
}

// The result may be too large where the stock is already lower. Everywhere else it must
// be exact.
TEST_P(BullHeightsOf, AreRightWhereTheyAreBelowTheStock)
{
    const Cutter cutter = GetParam();
    const TilePlace place = test::small_tile();
    test::Random random{4};
    for (const test::SmallMove& move : test::small_moves(4, 300)) {
        const StraightSweep sweep{cutter, move.from, move.to};
        TileHeights tile;
        for (double& z : tile)
            z = random.uniform(-4, 4);
        TileHeights heights;
        bull_heights(tile, place, cutter, move.swept(), heights);
        for (int k = 0; k < 64; ++k) {
            const double x = place.x[k % 8];
            const double y = place.y[k / 8];
            if (heights[k] < tile[k]) {
                EXPECT_TRUE(test::is_height(sweep, x, y, heights[k])) << k;
            } else {
                EXPECT_GE(sweep.height(x, y), tile[k] - 1e-12) << k;
            }
        }
    }
}

// A continued move need not cut again what the cutter has cleared where the move starts.
TEST_P(BullHeightsOf, OfAContinuedMoveAreTheSame)
{
    const Cutter cutter = GetParam();
    const TilePlace place = test::small_tile();
    test::Random random{5};
    for (const test::SmallMove& move : test::small_moves(5, 700)) {
        TileHeights tile;
        TileHeights high;
        high.fill(1e6);
        bull_heights(high, place, cutter, swept_move(move.from, move.from), tile);
        for (double& z : tile)
            z = std::min(z, random.uniform(-4, 8));
        SweptMove swept = move.swept();
        TileHeights whole;
        bull_heights(tile, place, cutter, swept, whole);
        swept.is_continued = true;
        TileHeights rest;
        bull_heights(tile, place, cutter, swept, rest);
        for (int k = 0; k < 64; ++k)
            EXPECT_NEAR(std::min(tile[k], rest[k]), std::min(tile[k], whole[k]), 1e-12)
                << move.from.transpose() << " to " << move.to.transpose() << " cell "
                << k;
    }
}

INSTANTIATE_TEST_SUITE_P(Corners, BullHeightsOf,
                         testing::Values(Cutter{5, 2}, Cutter{5, 0.01}, Cutter{5, 4.99},
                                         Cutter{0.1, 0.03}));

}  // namespace
}  // namespace endmill
