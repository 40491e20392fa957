// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/deviation/part_charts.h"

namespace endmill {

/// Returns the cells of a tile, in order.
std::vector<PartCell> tile_cells(const PartTile& tile);

/// Returns the rays at the middles of a tile's cells, in the order of the cells. Where
/// the surface has no normal, the normal is zero.
std::vector<PartRay> tile_rays(const PartCharts& charts, const PartTile& tile);
/// The same for known `cells` of the tile, from `tile_cells`; faster.
std::vector<PartRay> tile_rays(const PartCharts& charts, const PartTile& tile,
                               std::span<const PartCell> cells);

/// Returns only the points of these rays, faster; mm.
std::vector<Vec3> tile_points(const PartCharts& charts, const PartTile& tile);

/// Cuts the charts into tiles. The sides of the cells are at most 1.2 `pitch` long, and
/// about one pitch in the mean, by the partials at the corners and the middle of the
/// tile.
/// \param pitch in mm.
/// \throws DomainError unless 0 < pitch.
/// \throws LimitError if there are more than `most_cells` cells.
std::vector<PartTile> part_tiles(const PartCharts& charts, double pitch,
                                 std::size_t most_cells);

/// Returns the number of cells of all `tiles`.
std::size_t cell_count(const std::vector<PartTile>& tiles);

}  // namespace endmill
