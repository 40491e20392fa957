// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/deviation/detail/part_tiles.h"
#include "endmill/deviation/deviation.h"

namespace endmill {

/// A cell of a deviation with the ray at its middle.
struct DeviationCell {
    PartCell cell;
    PartRay ray;  ///< at its middle
};

/// Checks that a deviation is complete.
/// \throws DomainError unless it has one finite thickness and one finite area per cell.
void require_whole(const Deviation& deviation);

/// Returns the cell with this number in a tile.
/// \pre 0 <= number < tile.cells(), and the cell has an area.
/// \throws DomainError if `charts` are not those of the measurement.
DeviationCell deviation_cell(const PartCharts& charts, const PartTile& tile, int number);

/// Returns the cell with this number among the cells of all tiles.
/// \pre number < cell_count(deviation.tiles), and the cell has an area.
/// \throws DomainError if `charts` are not those of the measurement.
DeviationCell deviation_cell(const PartCharts& charts, const Deviation& deviation,
                             std::size_t number);

/// Computes the area that was judged and, weighted by area, the mean and the 99 %
/// quantile of the remaining stock. All are 0 without any area.
void add_areas(Deviation& deviation);

}  // namespace endmill
