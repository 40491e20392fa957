// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/visibility/sphere_grid.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// Faces of a convex part, whose cones are caps about their normals: nothing is in the way.
struct ConvexPart {
    std::vector<Vec3> normals;  ///< unit
    Angle incidence;            ///< how far a tool may lean from a normal
    /// On the sphere itself, between two directions that see all faces.
    Angle shortest_arc = Angle::degrees(0);
};

/// "cube": all faces of a cube but one; "prism": six sides and the top of a regular prism.
/// \throws DomainError for another word, or unless 0 < incidence < 90 degrees.
ConvexPart convex_part(const std::string& word, Angle incidence);

/// The cells of each face's cap.
VisibilityMap cap_map(const ConvexPart& part, const SphereGrid& grid);

/// The least angle between two cells that together see all faces, rad; pi if no two do.
/// cells^2 operations. \pre at most 64 faces.
double shortest_arc_of_two(const VisibilityMap& map, const SphereGrid& grid);

}  // namespace endmill
