// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Coordinates of the cells of a tile.
struct TilePlace {
    std::array<double, HeightStock::tile_side> x;  ///< mm, centres of the columns
    std::array<double, HeightStock::tile_side> y;  ///< mm, centres of the rows
    double bottom_z;                               ///< mm, bottom of the stock
};

/// Returns the coordinates of a tile of a stock.
TilePlace tile_place(const StockGrid& grid, int tile_column, int tile_row);

/// One number per cell of a tile, row by row.
using TileHeights = std::array<double, HeightStock::tile_size>;

/// Chooses one of two numbers that are both computed, so that the compiler needs no
/// branch.
inline double select(bool is_first, double first, double second)
{
    return is_first ? first : second;
}

/// The cells of a row in the coordinates of a move: s along it, e across it, both from
/// its start as in `StraightSweep`, and q = R^2 - e^2.
///
/// Every loop over a row computes all cases and selects one, and takes roots of absolute
/// values. This lets the compiler process several cells at once, with the same bits for
/// any number of them.
struct TileRow {
    std::array<double, HeightStock::tile_side> s;  ///< mm, along the move
    std::array<double, HeightStock::tile_side> e;  ///< mm, across the move
    std::array<double, HeightStock::tile_side> q;  ///< mm^2, R^2 - e^2
};

/// Returns row `j` of a tile.
/// \param R radius of the cutter, mm.
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

/// Computes `StraightSweep::height` of a ball of radius R at the centres of the cells, in
/// mm. It is infinite where the ball does not pass.
void ball_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

/// Computes the same for a flat cutter of radius R.
void flat_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

}  // namespace endmill
