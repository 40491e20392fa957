// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The cells that represent the cones of a part at a tool axis. For each facet that is
/// not accessible along the tool axis this is the accessible cell nearest to the axis.
/// Each cell is listed once, the nearest first. Facets that no cell reaches are left out.
///
/// If several cells are equally near (dot products within 1e-12), the lowest one is
/// taken. The facets are the paper's Group II, the cells its MD_j. O(cells * facets /
/// 64).
/// Source: [KangSuh, eq. (3), (4)]; docs/methods/five-axis-setup.md, section 4.
/// \param map cones. \param centres unit, one for each cell of `map`.
/// \param pose the cell whose centre is the tool axis.
/// \throws DomainError if there is not one centre for each cell, or if `pose` is not a
///         cell.
std::vector<std::size_t> nearest_cells(const VisibilityMap& map,
                                       std::span<const Vec3> centres, std::size_t pose);

}  // namespace endmill
