// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/stock_patch.h"

#include <algorithm>

#include "endmill/stock/detail/stock_probe.h"

namespace endmill {
namespace {

// Cells around the reach that interpolation needs: the centre of the next cell lies up to
// one and a half pitches away; half a pitch is added for rounding.
constexpr double margin_cells = 2;

}  // namespace

void StockPatch::copy(const HeightStock& stock, const Vec3& place, double reach)
{
    grid_ = stock.grid();
    const double half = reach + margin_cells * grid_.pitch;
    const double x = place.x() - grid_.low_x;
    const double y = place.y() - grid_.low_y;
    const TileRange columns =
        tiles_between(x - half, x + half, grid_.pitch, stock.tile_columns());
    const TileRange rows =
        tiles_between(y - half, y + half, grid_.pitch, stock.tile_rows());
    first_column_ = columns.first;
    first_row_ = rows.first;
    tile_columns_ = columns.last - columns.first + 1;
    heights_.clear();
    for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column) {
            const HeightStock::ConstTile tile = stock.tile(column, row);
            heights_.insert(heights_.end(), tile.begin(), tile.end());
        }
}

double StockPatch::bytes(const StockGrid& grid, double reach)
{
    const double half = reach + margin_cells * grid.pitch;
    const double tiles = 2 * half / (HeightStock::tile_side * grid.pitch) + 2;
    return tiles * tiles * HeightStock::tile_size * sizeof(double);
}

}  // namespace endmill
