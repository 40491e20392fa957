// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "endmill/deviation/detail/part_cell.h"

namespace endmill {

/// The most cells of a tile.
inline constexpr int most_tile_cells = 64;

/// A piece of a chart cut into cells: a quadrilateral into columns by rows, a triangle
/// into `columns` squared.
struct PartTile {
    PartCell whole;
    int columns;        ///< along the side from corner 0 to corner 1, 1 to 8
    int rows;           ///< along the side from corner 0 to the last; equal on a triangle
    std::size_t first;  ///< number of its first cell among those of all tiles
    int cells() const { return columns * rows; }  ///< at most most_tile_cells

    /// Its cell `number`, from 0.
    PartCell cell(int number) const;
};

/// The tile's cells, in order.
std::vector<PartCell> tile_cells(const PartTile& tile);

/// The rays at the middles of the tile's cells, in the order of these; the normal is zero
/// where the surface has none.
std::vector<PartRay> tile_rays(const PartCharts& charts, const PartTile& tile);

/// Only the points of these, sooner.
std::vector<Vec3> tile_points(const PartCharts& charts, const PartTile& tile);

/// Cuts the charts into tiles whose cells have sides of at most 1.2 `pitch`, about one
/// pitch in the mean, by the partials at the tile's corners and middle.
/// \param pitch in mm, positive.
/// \throws LimitError if there are more than `most_cells` cells.
std::vector<PartTile> part_tiles(const PartCharts& charts, double pitch,
                                 std::size_t most_cells);

/// Number of cells of all `tiles`.
std::size_t cell_count(const std::vector<PartTile>& tiles);

}  // namespace endmill
