// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/tile_clearance.h"

#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

TileHeights sloping_tile(test::Random& random)
{
    const double a = random.uniform(-2, 2);
    const double b = random.uniform(-2, 2);
    const double rough = random.uniform(0, 0.1);
    TileHeights tile;
    for (int k = 0; k < 64; ++k)
        tile[k] = a * (k % 8) * 0.1 + b * (k / 8) * 0.1 + random.uniform(0, rough);
    return tile;
}

TEST(TileTop, LiesOverAllCellsAndTouchesOne)
{
    const TilePlace place = test::small_tile();
    test::Random random{6};
    for (int n = 0; n < 200; ++n) {
        const TileHeights tile = sloping_tile(random);
        const TileTop top = tile_top(tile, place);
        double least = 1e9;
        for (int k = 0; k < 64; ++k)
            least = std::min(least, top.z + (place.x[k % 8] - top.x) * top.slope_x +
                                        (place.y[k / 8] - top.y) * top.slope_y - tile[k]);
        EXPECT_NEAR(least, 0, 1e-12);
    }
}

TEST(TileTop, OfAPlaneIsThePlane)
{
    const TilePlace place = test::small_tile();
    TileHeights tile;
    for (int k = 0; k < 64; ++k)
        tile[k] = 3 + 2 * place.x[k % 8] - 5 * place.y[k / 8];
    const TileTop top = tile_top(tile, place);
    EXPECT_NEAR(top.z, 3, 1e-13);
    EXPECT_NEAR(top.slope_x, 2, 1e-12);
    EXPECT_NEAR(top.slope_y, -5, 1e-12);
}

MoveBatch batch_of(const std::vector<test::SmallMove>& moves)
{
    MoveBatch batch;
    for (const test::SmallMove& move : moves)
        batch.add(move.swept(), static_cast<std::uint32_t>(batch.count));
    return batch;
}

class MayTouch : public testing::TestWithParam<Cutter> {};

// What is called clear must lower no cell; and of what lowers none most is called clear.
TEST_P(MayTouch, ANoIsCertainAndFrequent)
{
    const Cutter cutter = GetParam();
    const TilePlace place = test::small_tile();
    const SweptDisc disc{cutter.flat_radius(), cutter.corner_radius(),
                         cutter.corner_radius()};
    test::Random random{7};
    int misses = 0;
    int clear = 0;
    for (int n = 0; n < 30; ++n) {
        const TileHeights tile = sloping_tile(random);
        const auto moves = test::small_moves(100 + n, MoveBatch::capacity);
        const MoveBatch batch = batch_of(moves);
        std::array<std::uint8_t, MoveBatch::capacity> touches;
        may_touch(tile_top(tile, place), batch, disc, 0, batch.count, touches.data());
        for (int k = 0; k < batch.count; ++k) {
            TileHeights lowered = tile;
            const TileCut cut = cut_tile(lowered, place, cutter, moves[k].swept());
            if (!touches[k]) {
                EXPECT_EQ(cut.deepest, 0) << moves[k].from.transpose();
            }
            misses += cut.deepest == 0;
            clear += touches[k] == 0;
        }
    }
    EXPECT_GT(clear, 0.8 * misses);
}

INSTANTIATE_TEST_SUITE_P(BallFlatBull, MayTouch,
                         testing::Values(Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}));

}  // namespace
}  // namespace endmill
