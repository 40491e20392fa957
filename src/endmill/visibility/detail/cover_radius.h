// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/vec.h"

namespace endmill {

/// The largest angle, rad, from any direction to the nearest of `centres`: the farthest corner
/// of their Voronoi cells, each cut out of the plane that touches the sphere at its centre.
/// Absolute error below 1e-14. O(n^2).
/// \param centres unit, so many that each Voronoi cell lies within 30 degrees of its centre.
double cover_radius(std::span<const Vec3> centres);

}  // namespace endmill
