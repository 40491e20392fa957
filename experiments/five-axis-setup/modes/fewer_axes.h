// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/angle.h"
#include "support/named_cells.h"
#include "support/studied_part.h"

namespace endmill {

/// Cells whose centre lies on the great circle across `axis`, to 1e-9, and within `reach` of
/// `middle`. \param axis unit. \param middle unit.
std::vector<std::size_t> cells_on_circle(const SphereGrid& grid, const Vec3& axis,
                                         const Vec3& middle, Angle reach);

/// What these cells together do: cells, their number, and facets_left, those that none of them
/// reaches.
NamedCells reach_cells(const StudiedPart& part, const std::vector<std::size_t>& cells);

/// The best direction of a machine of three axes: see `reach_cells`.
NamedCells three_axes_cells(const StudiedPart& part);

/// The shortest arc about `axis` on which every facet has a cell: arc_deg, empty if there is
/// none. \param axis unit.
NamedCells four_axes_cells(const StudiedPart& part, const Vec3& axis);

/// The same about the best of the centres of `axes`, with cells up to `tolerance` off.
NamedCells best_four_axes_cells(const StudiedPart& part, const SphereGrid& axes,
                                Angle tolerance);

}  // namespace endmill
