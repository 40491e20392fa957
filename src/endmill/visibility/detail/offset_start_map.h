// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/core/angle.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// Visibility map by rays that start off their facet, as a program in single precision
/// would compute it. It shows the errors of that method beside the exact
/// `part_visibility`.
///
/// The ray of a facet starts at its centroid + start L n, where n is the unit normal and
/// L is the largest distance of a vertex from the origin. A direction is free if the
/// angle to n is below the incidence and the ray hits no triangle, decided in double
/// precision.
/// \param directions unit vectors. \param start relative offset, above 0.
VisibilityMap offset_start_map(const TriangleMesh& mesh, std::span<const Vec3> directions,
                               Angle incidence, double start);

}  // namespace endmill
