// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/stock_probe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/simulation/tile_cut.h"

namespace endmill {
namespace {

// A place of a line of `count` cells, between two of their centres.
struct BetweenCells {
    int cell;      // the one before it
    int next;      // the one after it; the same at the border
    double share;  // of the next one
};

// \param place in cells from where the line begins, in 0 … count.
BetweenCells between_cells(double place, int count)
{
    const double from_centre = std::clamp(place - 0.5, 0.0, count - 1.0);
    const int cell = static_cast<int>(from_centre);
    return {cell, std::min(cell + 1, count - 1), from_centre - cell};
}

// The first and last tile of a line that a move within [low, high] may reach.
std::pair<int, int> tiles_between(double low, double high, double pitch, int tiles)
{
    const double width = HeightStock::tile_side * pitch;
    return {static_cast<int>(std::clamp(std::floor(low / width), 0.0, tiles - 1.0)),
            static_cast<int>(std::clamp(std::floor(high / width), 0.0, tiles - 1.0))};
}

}  // namespace

std::optional<double> height_under(const HeightStock& stock, double x, double y)
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

void take_swept(HeightStock& stock, const Cutter& cutter, const SweptMove& move)
{
    const StockGrid& grid = stock.grid();
    const double reach = cutter.radius() + grid.pitch;
    const double x = move.x - grid.low_x;
    const double y = move.y - grid.low_y;
    const auto [low_x, high_x] = std::minmax({x, x + move.length * move.direction_x});
    const auto [low_y, high_y] = std::minmax({y, y + move.length * move.direction_y});
    const auto [first_column, last_column] =
        tiles_between(low_x - reach, high_x + reach, grid.pitch, stock.tile_columns());
    const auto [first_row, last_row] =
        tiles_between(low_y - reach, high_y + reach, grid.pitch, stock.tile_rows());
    for (int row = first_row; row <= last_row; ++row)
        for (int column = first_column; column <= last_column; ++column)
            cut_tile(stock.tile(column, row), tile_place(grid, column, row), cutter,
                     move);
}

}  // namespace endmill
