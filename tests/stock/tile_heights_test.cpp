// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_heights.h"

#include <cmath>

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

// A move towards the tile, level, sinking or rising, that ends before it, within it or
// beyond it. Beyond the end of a move that does not rise the ball is lowest at its end, so
// its height there is that of a ball at rest.
TEST(BallHeights, AreThoseOfTheSweepWhereverTheMoveEnds)
{
    const TilePlace place = test::small_tile();
    for (const double slope : {-2.0, -0.1, 0.0, 1e-9, 0.1, 2.0})
        for (double end = -6; end <= 2; end += 0.05)
            for (const double turn : {0.0, 0.4, 1.6}) {
                const Vec3 along{std::cos(turn), std::sin(turn), slope};
                const Vec3 from = (end - 0.3) * along + Vec3{0, 0, 0.2};
                const Vec3 to = end * along + Vec3{0, 0, 0.2};
                TileHeights heights;
                ball_heights(place, swept_move(from, to), 5, heights);
                const StraightSweep whole{Cutter::ball(5), from, to};
                const StraightSweep at_end{Cutter::ball(5), to, to};
                for (int k = 0; k < 64; ++k) {
                    const double x = place.x[k % 8];
                    const double y = place.y[k / 8];
                    EXPECT_TRUE(test::is_height(whole, x, y, heights[k]))
                        << "slope " << slope << " end " << end << " cell " << k;
                    EXPECT_TRUE(slope > 0 || end > -0.7 ||
                                test::is_height(at_end, x, y, heights[k]))
                        << "slope " << slope << " end " << end << " cell " << k;
                }
            }
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
