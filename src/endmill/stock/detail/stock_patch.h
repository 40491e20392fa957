// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/stock/height_stock.h"

namespace endmill {

/// A copy of some tiles of a stock. Cells keep their column and row, so
/// `interpolated_height` gives the same value as on the stock at the time of the copy, to
/// the bit.
class StockPatch {
public:
    /// Replaces the content by the tiles that are needed to interpolate within `reach` of
    /// `place` along x and y (in mm). The memory is reused.
    void copy(const HeightStock& stock, const Vec3& place, double reach);

    /// Upper bound of the memory of a copy, in bytes.
    static double bytes(const StockGrid& grid, double reach);

    /// The grid of the stock. \pre `copy` was called.
    const StockGrid& grid() const { return grid_; }

    /// Height of a cell of the stock, mm. \pre The cell lies in a copied tile.
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
