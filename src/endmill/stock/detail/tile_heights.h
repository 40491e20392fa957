// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Where the cells of a tile are.
struct TilePlace {
    std::array<double, HeightStock::tile_side> x;  ///< mm, centres of the columns
    std::array<double, HeightStock::tile_side> y;  ///< mm, centres of the rows
    double bottom_z;                               ///< mm
};

/// The place of a tile of a stock.
TilePlace tile_place(const StockGrid& grid, int tile_column, int tile_row);

/// A number for each cell of a tile.
using TileHeights = std::array<double, HeightStock::tile_size>;

/// One of two numbers, both of which are known: no branch.
inline double select(bool is_first, double first, double second)
{
    return is_first ? first : second;
}

/// The cells of a row against a move: s along and e across it from its start, as
/// `StraightSweep` has them, and q = R^2 - e^2. All loops over a row compute every case
/// and select, and take roots of magnitudes: so the compiler does several cells at a time,
/// with the same bits for every number of them.
struct TileRow {
    std::array<double, HeightStock::tile_side> s;  ///< mm
    std::array<double, HeightStock::tile_side> e;  ///< mm
    std::array<double, HeightStock::tile_side> q;  ///< mm^2
};

/// Row `j` of a tile.
inline TileRow tile_row(const TilePlace& place, int j, const SweptMove& move, double R)
{
    TileRow row;
    const double dy = place.y[j] - move.y;
    for (int i = 0; i < HeightStock::tile_side; ++i) {
        const double dx = place.x[i] - move.x;
        const double e = dy * move.direction_x - dx * move.direction_y;
        row.s[i] = dx * move.direction_x + dy * move.direction_y;
        row.e[i] = e;
        row.q[i] = (R - e) * (R + e);
    }
    return row;
}

/// StraightSweep::height of a ball of radius R at the centres of the cells, in mm;
/// infinite where it does not pass.
void ball_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

/// The same for a flat cutter of radius R.
void flat_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

}  // namespace endmill
