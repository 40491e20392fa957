// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// A box along the axes.
struct Block {
    Vec3 low;   ///< mm
    Vec3 high;  ///< mm
};

/// Where the cells of a stock lie: squares over the xy plane, in columns along x and rows
/// along y.
struct StockGrid {
    double low_x;     ///< mm, where the first column begins
    double low_y;     ///< mm, where the first row begins
    double pitch;     ///< mm, side of a cell
    int columns;      ///< along x
    int rows;         ///< along y
    double bottom_z;  ///< mm, below which there is no material

    double x(int column) const { return low_x + (column + 0.5) * pitch; }  ///< centre, mm
    double y(int row) const { return low_y + (row + 0.5) * pitch; }        ///< centre, mm

    /// Whether both have the same cells.
    friend bool operator==(const StockGrid&, const StockGrid&) = default;
};

/// The grid of whole cells over `box`, from its bottom: widened evenly on both sides, by
/// less than a pitch in all, where the pitch does not divide it.
/// \throws DomainError unless the box is finite and not turned over, and 0 < pitch.
/// \throws LimitError if there are more than 2^31 - 1 columns or rows.
StockGrid grid_over(const Block& box, double pitch);

/// Material between a bottom and a height at the centre of each cell; none where the
/// height is the bottom. Cells are kept in tiles of 8 by 8, one after the other, so that
/// what lies together on the part lies together in memory: 8 bytes a cell.
class HeightStock {
public:
    static constexpr int tile_side = 8;   ///< cells
    static constexpr int tile_size = 64;  ///< cells
    using Tile = std::span<double, tile_size>;
    using ConstTile = std::span<const double, tile_size>;

    /// Full of material up to `top_z`, in mm.
    /// \throws DomainError unless the pitch is positive, there is a cell, and all is
    ///         finite.
    HeightStock(const StockGrid& grid, double top_z);

    const StockGrid& grid() const { return grid_; }
    int tile_columns() const { return tile_columns_; }  ///< the last may be half empty
    int tile_rows() const { return tile_rows_; }        ///< the last may be half empty

    /// In mm, not below the bottom.
    /// \pre 0 <= column < columns, 0 <= row < rows
    double height(int column, int row) const { return heights_[index(column, row)]; }

    /// Heights below the bottom become the bottom.
    /// \pre as `height`; `z` is not NaN.
    void set_height(int column, int row, double z);

    /// The cells from (8 tile_column, 8 tile_row) on, along x first. Those beyond the
    /// grid are at the bottom, and must stay there.
    Tile tile(int tile_column, int tile_row)
    {
        return Tile{heights_.data() + tile_begin(tile_column, tile_row), tile_size};
    }
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

/// A block of material. Throws like `grid_over`.
HeightStock block_stock(const Block& block, double pitch);

/// The stock of heights that were kept: row by row, along x first, in mm.
/// \throws DomainError if there is not one for each cell, or one is not finite.
HeightStock stock_of_heights(const StockGrid& grid, std::span<const double> heights);

/// Volume of the material in mm^3: the sum over the cells of pitch^2 (height - bottom).
double stock_volume(const HeightStock& stock);

/// Lowest and highest place of a surface.
struct HeightRange {
    double low;   ///< mm
    double high;  ///< mm
};

/// Over the cells that have material; nothing if none has.
std::optional<HeightRange> height_range(const HeightStock& stock);

}  // namespace endmill
