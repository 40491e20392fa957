// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/detail/widest_registers.h"
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

/// A cell in the coordinates of a move: s along it and e across it, both from its start
/// as in `StraightSweep`.
struct CellOfMove {
    double s;  ///< mm
    double e;  ///< mm

    /// Returns R^2 - e^2 in mm^2 for a cutter of radius R: below 0 the cutter does not
    /// reach the cell.
    double q(double R) const { return (R - e) * (R + e); }
};

/// The cells of a tile in the coordinates of a move. Each coordinate is the sum of a part
/// of the column and a part of the row, so that little is left to compute for a cell.
///
/// Every loop over the cells computes all cases and selects one, and takes roots of
/// absolute values. This lets the compiler process several cells at once, with the same
/// bits for any number of them.
class TileOfMove {
public:
    TileOfMove(const TilePlace& place, const SweptMove& move)
    {
        for (int i = 0; i < HeightStock::tile_side; ++i) {
            const double dx = place.x[i] - move.x;
            const double dy = place.y[i] - move.y;
            column_s_[i] = dx * move.direction_x;
            column_e_[i] = dx * move.direction_y;
            row_s_[i] = dy * move.direction_y;
            row_e_[i] = dy * move.direction_x;
        }
    }

    /// The cell in column `i` of row `j`.
    CellOfMove cell(int i, int j) const
    {
        return {column_s_[i] + row_s_[j], row_e_[j] - column_e_[i]};
    }

private:
    using Parts = std::array<double, HeightStock::tile_side>;  // mm
    Parts column_s_;
    Parts column_e_;
    Parts row_s_;
    Parts row_e_;
};

/// Computes `StraightSweep::height` of a ball of radius R at the centres of the cells, in
/// mm. It is infinite where the ball does not pass.
void ball_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

/// Computes the same for a flat cutter of radius R.
void flat_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights);

}  // namespace endmill
