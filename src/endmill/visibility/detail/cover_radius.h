// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/vec.h"

namespace endmill {

/// Covering radius of a set of directions in rad: the largest angle from any direction to
/// the nearest of `centres`. It is the angle to the farthest corner of a Voronoi cell.
/// Each cell is clipped in the plane that touches the sphere at its centre. O(n^2).
/// Absolute error below 1e-14.
/// \param centres unit vectors.
/// \pre each Voronoi cell lies within 30 degrees of its centre.
double cover_radius(std::span<const Vec3> centres);

}  // namespace endmill
