// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_cut.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "small_moves.h"

namespace endmill {
namespace {

TEST(CutTile, ReportsTheRemovedMaterial)
{
    const TilePlace place = test::small_tile();
    for (const Cutter& cutter : {Cutter::ball(5), Cutter::flat(5), Cutter{5, 2}})
        for (const test::SmallMove& move : test::small_moves(5, 300)) {
            TileHeights tile;
            for (int k = 0; k < 64; ++k)
                tile[k] = 0.05 * (k % 9) - 0.3;
            const TileHeights before = tile;
            const TileCut cut = cut_tile(tile, place, cutter, move.swept());
            double sum = 0;
            double deepest = 0;
            for (int k = 0; k < 64; ++k) {
                EXPECT_LE(tile[k], before[k]);
                sum += before[k] - tile[k];
                deepest = std::max(deepest, before[k] - tile[k]);
            }
            EXPECT_NEAR(cut.depths, sum, 1e-12);
            EXPECT_EQ(cut.deepest, deepest);
        }
}

TEST(CutTile, EndsAtTheBottom)
{
    TilePlace place = test::small_tile();
    place.bottom_z = -0.5;
    TileHeights tile;
    tile.fill(1);
    const TileCut cut =
        cut_tile(tile, place, Cutter::flat(5), swept_move({0, 0, -7}, {1, 0, -7}));
    EXPECT_TRUE(std::ranges::all_of(tile, [](double z) { return z == -0.5; }));
    EXPECT_NEAR(cut.depths, 64 * 1.5, 1e-12);
    EXPECT_EQ(cut.deepest, 1.5);
}

// A cylinder of radius 2 begins 10 above the tip, over stock of height 1. Its depth is
// the height of the stock above its lower end, wherever it passes over a cell.
TEST(BodyDepth, IsHowFarTheCylinderIsInTheStock)
{
    const TilePlace place = test::small_tile();
    TileHeights tile;
    tile.fill(1);
    const BodyCylinder body{.radius = 2, .above = 10};
    const auto depth = [&](const Vec3& from, const Vec3& to) {
        return body_depth(tile, place, body, swept_move(from, to));
    };
    EXPECT_NEAR(depth({-9, 0, -9.5}, {9, 0, -9.5}), 0.5, 1e-14);
    EXPECT_EQ(depth({-9, 0, -9}, {9, 0, -9}), 0);
    EXPECT_EQ(depth({-9, 3, -20}, {9, 3, -20}), 0);
    EXPECT_NEAR(depth({0, 0, 5}, {0, 0, -12}), 3, 1e-14);
}

// The rim reaches a cell at (x, 0) when the axis is 2 before it. It does not arrive at a
// cell that the cylinder covers from the start.
TEST(BodyDepthOnArrival, IsThatAtTheRim)
{
    const TilePlace place = test::small_tile();
    TileHeights tile;
    tile.fill(1);
    const BodyCylinder body{.radius = 2, .above = 10};
    const auto depth = [&](const Vec3& from, const Vec3& to) {
        return body_depth_on_arrival(tile, place, body, swept_move(from, to));
    };
    EXPECT_NEAR(depth({-9, 0, -9.5}, {9, 0, -9.5}), 0.5, 1e-14);
    EXPECT_EQ(depth({0, 0, -12}, {1, 0, -12}), 0);
    // Downhill from -9 with slope -3. The rim reaches the last cell, at (0.35, 0.35),
    // when the axis is at 0.35 - sqrt(4 - 0.35^2), and the axis has come down
    // accordingly.
    const double reached = 0.35 - std::sqrt(4 - 0.35 * 0.35);
    EXPECT_NEAR(depth({-3, 0, -9}, {3, 0, -15}), reached + 3, 1e-12);
}

}  // namespace
}  // namespace endmill
