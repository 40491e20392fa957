// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_clearance.h"

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

TEST(UpperPlane, LiesOverAllCellsAndTouchesOne)
{
    const TilePlace place = test::small_tile();
    test::Random random{6};
    for (int n = 0; n < 200; ++n) {
        const TileHeights tile = sloping_tile(random);
        const UpperPlane top = upper_plane(tile, place);
        double least = 1e9;
        for (int k = 0; k < 64; ++k)
            least = std::min(least, top.z + (place.x[k % 8] - top.x) * top.slope_x +
                                        (place.y[k / 8] - top.y) * top.slope_y - tile[k]);
        EXPECT_NEAR(least, 0, 1e-12);
    }
}

TEST(UpperPlane, OfAPlaneIsThePlane)
{
    const TilePlace place = test::small_tile();
    TileHeights tile;
    for (int k = 0; k < 64; ++k)
        tile[k] = 3 + 2 * place.x[k % 8] - 5 * place.y[k / 8];
    const UpperPlane top = upper_plane(tile, place);
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

TEST(MoveBatch, KeepsSomeInTheirOrder)
{
    const auto moves = test::small_moves(12, 20);
    MoveBatch batch = batch_of(moves);
    std::array<std::uint8_t, MoveBatch::capacity> kept{};
    kept[3] = kept[4] = kept[19] = 1;
    batch.keep(kept.data());
    ASSERT_EQ(batch.count, 3);
    MoveBatch expected;
    for (const int k : {3, 4, 19})
        expected.add(moves[k].swept(), static_cast<std::uint32_t>(k));
    for (int k = 0; k < 3; ++k) {
        EXPECT_EQ(batch.number[k], expected.number[k]);
        EXPECT_EQ(batch.x[k], expected.x[k]);
        EXPECT_EQ(batch.z[k], expected.z[k]);
        EXPECT_EQ(batch.dy[k], expected.dy[k]);
        EXPECT_EQ(batch.per_length2[k], expected.per_length2[k]);
    }
}

TEST(CommonTop, LiesOverAllTilesAndSpansThem)
{
    const StockGrid grid{.low_x = 3,
                         .low_y = -2,
                         .pitch = 0.1,
                         .columns = 24,
                         .rows = 16,
                         .bottom_z = -100};
    test::Random random{13};
    for (int n = 0; n < 100; ++n) {
        std::vector<UpperPlane> tops;
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 3; ++i)
                tops.push_back(upper_plane(sloping_tile(random), tile_place(grid, i, j)));
        const UpperPlane common = common_upper_plane(tops);
        for (int row = 0; row < 16; ++row)
            for (int column = 0; column < 24; ++column) {
                const double x = grid.x(column);
                const double y = grid.y(row);
                const UpperPlane& top = tops[row / 8 * 3 + column / 8];
                const double z =
                    top.z + (x - top.x) * top.slope_x + (y - top.y) * top.slope_y;
                EXPECT_GE(common.z + (x - common.x) * common.slope_x +
                              (y - common.y) * common.slope_y,
                          z - 1e-12);
                EXPECT_LE(std::abs(x - common.x), common.half_width + 1e-12);
                EXPECT_LE(std::abs(y - common.y), common.half_width + 1e-12);
            }
    }
}

class MayTouch : public testing::TestWithParam<Cutter> {};

// A move that is reported clear must lower no cell. Of the moves that lower none, most
// must be reported clear.
TEST_P(MayTouch, IsFalseOnlyIfCertainAndOften)
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
        may_touch(upper_plane(tile, place), batch, disc, {0, batch.count},
                  touches.data());
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
