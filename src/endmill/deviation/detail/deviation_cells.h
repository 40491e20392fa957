// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/deviation/deviation.h"

namespace endmill {

/// A cell of a deviation and the ray at its middle.
struct DeviationCell {
    PartCell cell;
    PartRay ray;
};

/// \throws DomainError unless `deviation` has a value and an area for each cell of its
///         tiles, and all are finite.
void require_whole(const Deviation& deviation);

/// Cell `number` of a tile. \pre 0 <= number < tile.cells(), and the cell has an area.
/// \throws DomainError if `charts` are not those of the deviation.
DeviationCell deviation_cell(const PartCharts& charts, const PartTile& tile, int number);

/// Cell `number` of all, found by the tile that holds it.
/// \pre number < cell_count(deviation.tiles), and the cell has an area.
/// \throws DomainError as above.
DeviationCell deviation_cell(const PartCharts& charts, const Deviation& deviation,
                             std::size_t number);

}  // namespace endmill
