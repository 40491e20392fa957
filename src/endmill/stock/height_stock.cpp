// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/height_stock.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// A width that is a whole number of cells but for its rounding is that number of cells.
constexpr double whole_cells_slack = 1e-9;  // cells

int cells_across(double width, double pitch)
{
    const double cells = std::max(1.0, std::ceil(width / pitch - whole_cells_slack));
    if (!(cells <= std::numeric_limits<int>::max()))
        throw LimitError{"a stock of " + to_text(width) + " mm would have " +
                         to_text(cells) + " cells of " + to_text(pitch) +
                         " mm in a line; expected at most 2^31 - 1"};
    return static_cast<int>(cells);
}

int tiles_across(int cells)
{
    return (cells - 1) / HeightStock::tile_side + 1;
}

}  // namespace

StockGrid grid_over(const Block& box, double pitch)
{
    require(box.low.allFinite() && box.high.allFinite() &&
                (box.high - box.low).minCoeff() >= 0,
            "grid_over: the box must be finite and not turned over");
    require(std::isfinite(pitch) && pitch > 0, "grid_over: need 0 < pitch");
    const Vec3 size = box.high - box.low;
    const int columns = cells_across(size.x(), pitch);
    const int rows = cells_across(size.y(), pitch);
    return {.low_x = box.low.x() - (columns * pitch - size.x()) / 2,
            .low_y = box.low.y() - (rows * pitch - size.y()) / 2,
            .pitch = pitch,
            .columns = columns,
            .rows = rows,
            .bottom_z = box.low.z()};
}

HeightStock::HeightStock(const StockGrid& grid, double top_z) : grid_{grid}
{
    require(grid.columns >= 1 && grid.rows >= 1, "HeightStock: need a cell");
    require(std::isfinite(grid.pitch) && grid.pitch > 0, "HeightStock: need 0 < pitch");
    require(std::isfinite(grid.low_x) && std::isfinite(grid.low_y) &&
                std::isfinite(grid.bottom_z) && std::isfinite(top_z),
            "HeightStock: a coordinate is not finite");
    tile_columns_ = tiles_across(grid.columns);
    tile_rows_ = tiles_across(grid.rows);
    heights_.assign(static_cast<std::size_t>(tile_columns_) * tile_rows_ * tile_size,
                    grid.bottom_z);
    if (top_z <= grid.bottom_z)
        return;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            heights_[index(column, row)] = top_z;
}

void HeightStock::set_height(int column, int row, double z)
{
    heights_[index(column, row)] = std::max(grid_.bottom_z, z);
}

HeightStock block_stock(const Block& block, double pitch)
{
    return {grid_over(block, pitch), block.high.z()};
}

HeightStock stock_of_heights(const StockGrid& grid, std::span<const double> heights)
{
    HeightStock stock{grid, grid.bottom_z};
    require(heights.size() == static_cast<std::size_t>(grid.columns) * grid.rows,
            "stock_of_heights: need a height for each cell");
    require(std::ranges::all_of(heights, [](double z) { return std::isfinite(z); }),
            "stock_of_heights: a height is not finite");
    std::size_t next = 0;
    for (int row = 0; row < grid.rows; ++row)
        for (int column = 0; column < grid.columns; ++column)
            stock.set_height(column, row, heights[next++]);
    return stock;
}

double stock_volume(const HeightStock& stock)
{
    const double bottom = stock.grid().bottom_z;
    double sum = 0;
    for (int j = 0; j < stock.tile_rows(); ++j)
        for (int i = 0; i < stock.tile_columns(); ++i) {
            double in_tile = 0;
            for (const double z : stock.tile(i, j))
                in_tile += z - bottom;
            sum += in_tile;
        }
    return sum * stock.grid().pitch * stock.grid().pitch;
}

std::optional<HeightRange> height_range(const HeightStock& stock)
{
    const double bottom = stock.grid().bottom_z;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    HeightRange range{infinite, -infinite};
    for (int j = 0; j < stock.tile_rows(); ++j)
        for (int i = 0; i < stock.tile_columns(); ++i)
            for (const double z : stock.tile(i, j))
                if (z > bottom)
                    range = {std::min(range.low, z), std::max(range.high, z)};
    if (range.low > range.high)
        return std::nullopt;
    return range;
}

}  // namespace endmill
