// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/stock_probe.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

TileRange tiles_between(double low, double high, double pitch, int tiles)
{
    const double width = HeightStock::tile_side * pitch;
    return {static_cast<int>(std::clamp(std::floor(low / width), 0.0, tiles - 1.0)),
            static_cast<int>(std::clamp(std::floor(high / width), 0.0, tiles - 1.0))};
}

void remove_swept(HeightStock& stock, const Cutter& cutter, const SweptMove& move)
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
