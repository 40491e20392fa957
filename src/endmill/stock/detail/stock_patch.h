// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/stock/height_stock.h"

namespace endmill {

/// Some tiles of a stock as they were when they were copied, under the numbers that their
/// cells have in the stock: `height_under` finds in it what it found there, to the bit.
class StockPatch {
public:
    /// Copies the tiles of the cells within `reach` of a place along x and y (all in mm), and
    /// of the cells beside these; what was here before is forgotten, its memory used again.
    void copy(const HeightStock& stock, const Vec3& place, double reach);

    /// Bytes of a copy, at most.
    static double bytes(const StockGrid& grid, double reach);

    /// Of the stock. \pre `copy` was called.
    const StockGrid& grid() const { return grid_; }

    /// In mm, of a cell of the stock. \pre The cell is within what was copied.
    double height(int column, int row) const
    {
        constexpr int side = HeightStock::tile_side;
        const std::size_t tile =
            static_cast<std::size_t>(row / side - first_row_) * tile_columns_ +
            (column / side - first_column_);
        return heights_[tile * HeightStock::tile_size +
                        static_cast<std::size_t>(row % side) * side + column % side];
    }

private:
    StockGrid grid_ = {};
    int first_column_ = 0;  // of tiles
    int first_row_ = 0;
    int tile_columns_ = 0;
    std::vector<double> heights_;
};

}  // namespace endmill
