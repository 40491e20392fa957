// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// A place of a line of cells, between two of their centres.
struct BetweenCells {
    int cell;      ///< the one before it
    int next;      ///< the one after it; the same at the border
    double share;  ///< of the next one
};

/// \param place in cells from where the line begins, in 0 … count. \param count from 1.
inline BetweenCells between_cells(double place, int count)
{
    const double from_centre = std::clamp(place - 0.5, 0.0, count - 1.0);
    const int cell = static_cast<int>(from_centre);
    return {cell, std::min(cell + 1, count - 1), from_centre - cell};
}

/// Height in mm at a place, linear between the centres of the cells; nothing beside the grid.
/// \tparam Heights a HeightStock, or what has its grid and height.
template <typename Heights>
std::optional<double> height_under(const Heights& stock, double x, double y)
{
    const StockGrid& grid = stock.grid();
    const double column = (x - grid.low_x) / grid.pitch;
    const double row = (y - grid.low_y) / grid.pitch;
    if (!(column >= 0 && column <= grid.columns && row >= 0 && row <= grid.rows))
        return std::nullopt;
    const BetweenCells i = between_cells(column, grid.columns);
    const BetweenCells j = between_cells(row, grid.rows);
    return std::lerp(
        std::lerp(stock.height(i.cell, j.cell), stock.height(i.next, j.cell), i.share),
        std::lerp(stock.height(i.cell, j.next), stock.height(i.next, j.next), i.share),
        j.share);
}

/// Tiles of a line, the last one among them.
struct TileRange {
    int first;
    int last;
};

/// The tiles of a line of `tiles` that reach into [low, high], in mm from where the line
/// begins; the nearest one if none does.
TileRange tiles_between(double low, double high, double pitch, int tiles);

/// Takes from `stock` what `cutter` sweeps on `move`.
void take_swept(HeightStock& stock, const Cutter& cutter, const SweptMove& move);

}  // namespace endmill
