// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_cut.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/stock/detail/bull_heights.h"

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;

// Lowers the cells of a tile to `heights`, but not below the bottom. The depths are summed
// in eight columns, so that every register width adds in the same order.
ENDMILL_WIDEST_REGISTERS
TileCut lower(double* __restrict tile, double bottom_z, const double* __restrict heights)
{
    std::array<double, side> sums{};
    std::array<double, side> deepest{};
    for (int k = 0; k < HeightStock::tile_size; k += side) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const double before = tile[k + i];
            const double left = heights[k + i] > bottom_z ? heights[k + i] : bottom_z;
            const double after = left < before ? left : before;
            const double depth = before - after;
            tile[k + i] = after;
            sums[i] += depth;
            deepest[i] = depth > deepest[i] ? depth : deepest[i];
        }
    }
    TileCut cut{0, 0};
    for (int i = 0; i < side; ++i) {
        cut.depths += sums[i];
        cut.deepest = std::max(cut.deepest, deepest[i]);
    }
    return cut;
}

}  // namespace

TileCut cut_tile(HeightStock::Tile tile, const TilePlace& place, const Cutter& cutter,
                 const SweptMove& move)
{
    TileHeights heights;
    if (cutter.is_ball())
        ball_heights(place, move, cutter.radius(), heights);
    else if (cutter.is_flat())
        flat_heights(place, move, cutter.radius(), heights);
    else
        bull_heights(tile, place, cutter, move, heights);
    return lower(tile.data(), place.bottom_z, heights.data());
}

double body_depth(HeightStock::ConstTile tile, const TilePlace& place,
                  const BodyCylinder& body, const SweptMove& move)
{
    TileHeights heights;
    flat_heights(place, move, body.radius, heights);
    double depth = 0;
    for (int k = 0; k < HeightStock::tile_size; ++k)
        if (tile[k] > place.bottom_z)
            depth = std::max(depth, tile[k] - (heights[k] + body.above));
    return depth;
}

double body_depth_on_arrival(HeightStock::ConstTile tile, const TilePlace& place,
                             const BodyCylinder& body, const SweptMove& move)
{
    double depth = 0;
    for (int k = 0; k < HeightStock::tile_size; ++k) {
        const double dx = place.x[k % side] - move.x;
        const double dy = place.y[k / side] - move.y;
        const double s = dx * move.direction_x + dy * move.direction_y;
        const double e = dy * move.direction_x - dx * move.direction_y;
        const double q = (body.radius - e) * (body.radius + e);
        if (q < 0 || tile[k] <= place.bottom_z)
            continue;
        const double arrival = s - std::sqrt(q);
        if (arrival > 0 && arrival <= move.length)
            depth =
                std::max(depth, tile[k] - (move.z + move.slope * arrival + body.above));
    }
    return depth;
}

}  // namespace endmill
