// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/angle.h"
#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// Cells whose centre is within 1e-9 of the great circle normal to `axis` and within
/// `reach` of `middle`. \param axis unit. \param middle unit.
std::vector<std::size_t> cells_on_circle(const SphereGrid& grid, const Vec3& axis,
                                         const Vec3& middle, Angle reach);

/// Reach of the cells together: cells, their number, and facets_left, the number of
/// facets that none of them reaches.
NamedCells reach_cells(const StudiedPart& part, const std::vector<std::size_t>& cells);

/// Reach of the best direction of a machine with three axes, as in `reach_cells`, and
/// setups, the least number of directions that together reach every facet that any cell
/// reaches; empty if it is above `most_setups`.
NamedCells three_axes_cells(const StudiedPart& part, int most_setups);

/// arc_deg: the shortest arc about `axis` on which every facet has a cell; empty if there
/// is none.
/// \param axis unit.
NamedCells four_axes_cells(const StudiedPart& part, const Vec3& axis);

/// The same about the best of the centres of `axes`, with cells at most `tolerance` from
/// the circle.
NamedCells best_four_axes_cells(const StudiedPart& part, const SphereGrid& axes,
                                Angle tolerance);

}  // namespace endmill
