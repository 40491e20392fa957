// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// The normals in a disc of the great circles through two cells.
///
/// A range of tool directions without width, or without height, lies on such a circle, or
/// it is a single direction or a pair of opposite ones. Normals that differ by 1e-9 rad or
/// less are listed once; the circle through a pair of opposite cells is not determined and
/// is left out. Normals are accurate to 1e-15 divided by the sine of the angle between the
/// cells. O(cells + pairs of the cells near the circle about `middle`).
/// \param centres unit vectors, of the cells. \param middle unit, of the disc.
/// \param radius of the disc as a chord, below 1.
/// \param most largest number of normals.
/// \return unit normals, in the order of their first cells; nothing if there are more
///         than `most`.
std::vector<Vec3> cell_circles(std::span<const Vec3> centres, const Vec3& middle,
                               double radius, std::size_t most);

}  // namespace endmill
