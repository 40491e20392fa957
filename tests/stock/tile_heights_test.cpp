// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_heights.h"

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

TEST(TilePlace, HasTheCentresOfTheGrid)
{
    const StockGrid grid{
        .low_x = 1, .low_y = 2, .pitch = 0.5, .columns = 40, .rows = 40, .bottom_z = -3};
    const TilePlace place = tile_place(grid, 2, 3);
    for (int k = 0; k < 8; ++k) {
        EXPECT_EQ(place.x[k], grid.x(16 + k));
        EXPECT_EQ(place.y[k], grid.y(24 + k));
    }
    EXPECT_EQ(place.bottom_z, -3);
}

class TileHeightsOf : public testing::TestWithParam<Cutter> {};

TEST_P(TileHeightsOf, AreThoseOfTheSweep)
{
    const Cutter cutter = GetParam();
    const TilePlace place = test::small_tile();
    for (const test::SmallMove& move : test::small_moves(2, 700)) {
        const StraightSweep sweep{cutter, move.from, move.to};
        TileHeights heights;
        if (cutter.is_ball())
            ball_heights(place, move.swept(), cutter.radius(), heights);
        else
            flat_heights(place, move.swept(), cutter.radius(), heights);
        for (int k = 0; k < 64; ++k)
            EXPECT_TRUE(
                test::is_height(sweep, place.x[k % 8], place.y[k / 8], heights[k]))
                << move.from.transpose() << " to " << move.to.transpose() << " cell "
                << k;
    }
}

INSTANTIATE_TEST_SUITE_P(BallFlat, TileHeightsOf,
                         testing::Values(Cutter::ball(5), Cutter::flat(5),
                                         Cutter::ball(0.05), Cutter::flat(0.05)));

}  // namespace
}  // namespace endmill
