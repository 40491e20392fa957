// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/height_stock.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

#include "endmill/core/detail/large_pages.h"
#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// A width within this tolerance of a whole number of cells gets that number of cells, so
// that rounding adds no column.
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

// Working memory of `remove_along` for the current moves and their groups; measured, with
// a margin.
constexpr double work_bytes_per_cell = 1.5;
// Working memory that does not depend on the grid: the moves and batches of each thread.
constexpr double bytes_of_work = 2.5e6;

// Upper bound of the number of tiles over a width. One tile is added because the grid
// extends the width to whole cells and the last tile may be partly used.
double tiles_over(double width, double pitch)
{
    return std::ceil(width / pitch / HeightStock::tile_side) + 1;
}

std::string two_digits(double value)
{
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.2g", value);
    return text.data();
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
    assign_in_large_pages(
        heights_, static_cast<std::size_t>(tile_columns_) * tile_rows_ * tile_size,
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

Block material_box(const HeightStock& stock)
{
    const StockGrid& grid = stock.grid();
    const auto range = height_range(stock);
    return {{grid.low_x, grid.low_y, grid.bottom_z},
            {grid.low_x + grid.columns * grid.pitch, grid.low_y + grid.rows * grid.pitch,
             range ? range->high : grid.bottom_z}};
}

double required_bytes(const Block& box, double pitch, double extra)
{
    const Vec3 size = box.high - box.low;
    return tiles_over(size.x(), pitch) * tiles_over(size.y(), pitch) *
               HeightStock::tile_size * (sizeof(double) + work_bytes_per_cell + extra) +
           bytes_of_work;
}

// Tries the pitches of two digits in increasing order, 1.0, 1.1, ... 9.9 times a power of
// ten, starting from the lower bound, until one fits.
std::optional<double> fitting_pitch(const Block& box, double bytes, double extra)
{
    const Vec3 size = box.high - box.low;
    const double largest = std::max(size.x(), size.y());
    // With a pitch as large as the box there are two tiles along each side.
    const double least_bytes =
        4.0 * HeightStock::tile_size * (sizeof(double) + work_bytes_per_cell + extra) +
        bytes_of_work;
    if (!(bytes >= least_bytes) || !(largest > 0))
        return std::nullopt;
    // Lower bound of the pitch: it counts only the heights, without the margins of tiles
    // and work.
    const double bound = std::sqrt(size.x() * size.y() * sizeof(double) / bytes);
    // Limits the logarithm for a box without area. No stock of so many cells fits.
    constexpr double least_pitch_share = 1e-9;
    double decade = std::pow(
        10, std::floor(std::log10(std::max(bound, largest * least_pitch_share))));
    for (;; decade *= 10)
        for (int digits = 10; digits < 100; ++digits) {
            // Goes through the text, so that the pitch is the double nearest to its two
            // digits.
            const double pitch = *number_from_text(two_digits(decade * digits / 10));
            if (pitch >= bound && required_bytes(box, pitch, extra) <= bytes)
                return pitch;
        }
}

void require_stock_memory(const Block& box, double pitch, double memory_gib, double extra)
{
    require(box.low.allFinite() && box.high.allFinite() &&
                (box.high - box.low).minCoeff() >= 0 && std::isfinite(pitch) && pitch > 0,
            "require_stock_memory: need a finite box and 0 < pitch");
    const double bytes = required_bytes(box, pitch, extra);
    if (bytes <= memory_gib * bytes_per_gib)
        return;
    const Vec3 size = box.high - box.low;
    const auto fits = fitting_pitch(box, memory_gib * bytes_per_gib, extra);
    throw LimitError{"a stock of " + to_text(size.x()) + " x " + to_text(size.y()) +
                     " mm in cells of " + to_text(pitch) + " mm would need about " +
                     two_digits(bytes / bytes_per_gib) + " GiB; expected at most " +
                     to_text(memory_gib) + " GiB (--max-memory)" +
                     (fits && std::isfinite(*fits)
                          ? ", which cells of " + to_text(*fits) + " mm fit"
                          : std::string{})};
}

}  // namespace endmill
