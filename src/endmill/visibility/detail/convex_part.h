// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// Faces of a convex part. Nothing hides a face, so its visibility cone is a cap about
/// its normal.
struct ConvexPart {
    std::vector<Vec3> normals;  ///< unit
    Angle incidence;            ///< largest angle of the tool from a normal
    /// Least angle between two directions that together see all faces, in closed form.
    Angle shortest_arc = Angle::degrees(0);
};

/// The part "cube" (the top and the four sides of a cube) or "prism" (the top and the six
/// sides of a regular hexagonal prism).
/// \throws DomainError for another word, or unless 0 < incidence < 90 degrees.
ConvexPart convex_part(const std::string& word, Angle incidence);

/// Visibility map of the part on `grid`: the cells whose centre lies in the cap of a
/// face.
/// \pre at most 64 faces.
VisibilityMap cap_map(const ConvexPart& part, const SphereGrid& grid);

/// Least angle in rad between the centres of two cells that together see all faces that
/// any cell sees; pi if there are none. Compares all pairs of cells. \pre at most 64
/// faces.
double shortest_arc_of_two(const VisibilityMap& map, const SphereGrid& grid);

}  // namespace endmill
