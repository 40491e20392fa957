// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The distinct cells that are, each for some facet, the accessible one nearest to the centre
/// of cell `pose`; only for facets that are not accessible along `pose` itself, the paper's
/// Group II. From the nearest outwards; of centres equally near (dot products within 1e-12)
/// the lowest cell counts. Facets that no cell reaches have none.
///
/// The bit columns of the cells are walked outwards, in 64 classes of the dot product, and
/// only cells that still reach a wanted facet are sorted: O(cells * facets / 64).
/// Source: [KangSuh, eq. (3), (4)].
/// \param centres unit, one for each cell of `map`.
/// \throws DomainError unless there is a centre for each cell, and `pose` is one of them.
std::vector<std::size_t> nearest_cells(const VisibilityMap& map,
                                       std::span<const Vec3> centres, std::size_t pose);

}  // namespace endmill
