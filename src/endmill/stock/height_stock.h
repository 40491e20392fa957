// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

/// \file
/// The stock as a height field: a grid of square cells with one height at the
/// centre of each. The functions at the end estimate the memory that a stock takes and
/// choose a pitch that fits.

namespace endmill {

/// A box along the coordinate axes.
struct Block {
    Vec3 low;   ///< mm
    Vec3 high;  ///< mm
};

/// The grid of a stock: square cells in the xy plane, in columns along x and rows along
/// y.
struct StockGrid {
    double low_x;     ///< mm, start of the first column
    double low_y;     ///< mm, start of the first row
    double pitch;     ///< mm, side of a cell
    int columns;      ///< number of cells along x
    int rows;         ///< number of cells along y
    double bottom_z;  ///< mm, lower end of the material

    /// Coordinate x of a column's centres, mm.
    double x(int column) const { return low_x + (column + 0.5) * pitch; }
    /// Coordinate y of a row's centres, mm.
    double y(int row) const { return low_y + (row + 0.5) * pitch; }

    /// Whether both grids have the same cells and bottom.
    friend bool operator==(const StockGrid&, const StockGrid&) = default;
};

/// Returns the grid of whole cells that covers `box`. If the pitch does not divide a side
/// of the box, the grid exceeds the box by the same length on both sides, by less than a
/// pitch in all.
/// \param box in mm; its low corner must not exceed its high corner.
/// \param pitch side of a cell, mm.
/// \throws DomainError unless the box is finite and low <= high, and 0 < pitch.
/// \throws LimitError if there are more than 2^31 - 1 columns or rows.
StockGrid grid_over(const Block& box, double pitch);

/// A height field: each cell is filled from the bottom to one height, which is exact at
/// the cell's centre. A cell whose height is the bottom holds no material. The cells are
/// stored in tiles of 8 by 8, so that neighbours on the part are neighbours in memory. A
/// cell takes 8 bytes.
class HeightStock {
public:
    static constexpr int tile_side = 8;         ///< cells along a side of a tile
    static constexpr int tile_size = 64;        ///< cells of a tile
    using Tile = std::span<double, tile_size>;  ///< heights of a tile, mm
    using ConstTile = std::span<const double, tile_size>;  ///< heights of a tile, mm

    /// A stock filled with material up to `top_z`, in mm.
    /// \throws DomainError unless the pitch is positive, the grid has a cell, and all
    ///         coordinates are finite.
    HeightStock(const StockGrid& grid, double top_z);

    const StockGrid& grid() const { return grid_; }  ///< the cells
    /// Number of tiles along x. The last tile may extend beyond the grid.
    int tile_columns() const { return tile_columns_; }
    /// Number of tiles along y. The last tile may extend beyond the grid.
    int tile_rows() const { return tile_rows_; }

    /// Height of a cell in mm, at least that of the bottom.
    /// \pre 0 <= column < columns, 0 <= row < rows
    double height(int column, int row) const { return heights_[index(column, row)]; }

    /// Sets the height of a cell; a height below the bottom becomes the bottom.
    /// \pre 0 <= column < columns, 0 <= row < rows, and `z` is not NaN.
    void set_height(int column, int row, double z);

    /// Heights of the tile whose first cell is (8 tile_column, 8 tile_row), x running
    /// fastest. Cells beyond the grid are at the bottom and must stay there.
    Tile tile(int tile_column, int tile_row)
    {
        return Tile{heights_.data() + tile_begin(tile_column, tile_row), tile_size};
    }
    /// The same for reading.
    ConstTile tile(int tile_column, int tile_row) const
    {
        return ConstTile{heights_.data() + tile_begin(tile_column, tile_row), tile_size};
    }

private:
    std::size_t tile_begin(int tile_column, int tile_row) const
    {
        return (static_cast<std::size_t>(tile_row) * tile_columns_ + tile_column) *
               tile_size;
    }
    std::size_t index(int column, int row) const
    {
        return tile_begin(column / tile_side, row / tile_side) +
               static_cast<std::size_t>(row % tile_side) * tile_side + column % tile_side;
    }

    StockGrid grid_;
    int tile_columns_;
    int tile_rows_;
    std::vector<double> heights_;
};

/// Returns a block of material. Throws like `grid_over`.
HeightStock block_stock(const Block& block, double pitch);

/// Returns the stock with the given heights.
/// \param heights in mm, one per cell, row by row, x running fastest.
/// \throws DomainError if their number is not that of the cells, or one is not finite.
HeightStock stock_of_heights(const StockGrid& grid, std::span<const double> heights);

/// Returns the volume of the material in mm^3: the sum of pitch^2 (height - bottom) over
/// the cells.
double stock_volume(const HeightStock& stock);

/// Lowest and highest height of a surface.
struct HeightRange {
    double low;   ///< mm
    double high;  ///< mm
};

/// Returns the range of heights over the cells with material; nothing if no cell has any.
std::optional<HeightRange> height_range(const HeightStock& stock);

/// Returns the box of the grid from its bottom to the highest material. Without material
/// the box has no height.
Block material_box(const HeightStock& stock);

/// Returns an upper bound of the memory in bytes that a stock over `box` takes, including
/// the working memory of `remove_along` but not its result, which grows with the path.
/// \param extra bytes per cell for other data made from the stock.
/// \pre the box is finite with low <= high, and 0 < pitch.
double required_bytes(const Block& box, double pitch, double extra = 0);

/// Returns the finest pitch in mm, of two decimal digits, at which a stock over `box`
/// fits into `bytes`.
/// \param extra as in `required_bytes`.
/// \return nothing if not even one tile fits, or if the box has no width and no depth.
std::optional<double> fitting_pitch(const Block& box, double bytes, double extra = 0);

/// Checks that a stock over `box` fits into `memory_gib` GiB. It allocates nothing.
/// \param extra as in `required_bytes`.
/// \throws DomainError unless the box is finite with low <= high, and 0 < pitch.
/// \throws LimitError if it does not fit; the message states the need, the limit and a
///         pitch that fits.
void require_stock_memory(const Block& box, double pitch, double memory_gib,
                          double extra = 0);

}  // namespace endmill
