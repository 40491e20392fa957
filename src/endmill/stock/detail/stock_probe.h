// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// A place in a line of cells, between the centres of two of them.
struct BetweenCells {
    int cell;      ///< number of the cell before the place
    int next;      ///< number of the cell after it; the same cell at the border
    double share;  ///< weight of the next cell, 0 to 1
};

/// Returns the two cells between whose centres `place` lies.
/// \param place in cells from the start of the line, in 0 … count.
/// \param count number of cells, at least 1.
inline BetweenCells between_cells(double place, int count)
{
    const double from_centre = std::clamp(place - 0.5, 0.0, count - 1.0);
    const int cell = static_cast<int>(from_centre);
    return {cell, std::min(cell + 1, count - 1), from_centre - cell};
}

/// Returns the height of the stock at a place in mm, bilinear between the centres of the
/// cells.
/// \tparam Heights a HeightStock, or a type with the same `grid` and `height`.
/// \param x in mm.
/// \param y in mm.
/// \return nothing outside the grid.
template <typename Heights>
std::optional<double> interpolated_height(const Heights& stock, double x, double y)
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

/// A range of tiles in a line, including the last.
struct TileRange {
    int first;
    int last;
};

/// Returns the tiles of a line that overlap [low, high]; the nearest tile if none does.
/// \param low, high in mm from the start of the line.
/// \param tiles number of tiles in the line.
TileRange tiles_between(double low, double high, double pitch, int tiles);

/// Removes from `stock` the volume that `cutter` sweeps on `move`.
void remove_swept(HeightStock& stock, const Cutter& cutter, const SweptMove& move);

}  // namespace endmill
