// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "endmill/core/detail/lanes.h"
#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"
#include "endmill/visibility/detail/part_facets.h"

namespace endmill {

/// A few facets near each other.
struct FacetGroup {
    int count;  ///< how many they are; what follows repeats the last
    std::array<std::int32_t, float_lanes> facet;  ///< their numbers
    std::array<std::array<std::int32_t, float_lanes>, 3>
        corner;  ///< [corner]: numbers of points
};

/// The facets of a part that have an area, in groups. What belongs together lies together in the memory, whatever
/// the order in the part.
struct FacetGroups {
    std::vector<Vec3>
        points;  ///< mm, those of the part in the order in which they are used
    std::vector<FacetGroup> groups;  ///< neighbours are near each other, too
    std::vector<Vec3>
        centroids;  ///< mm, of the facets of all groups, one after the other
};

/// \pre `facets` are those of `part`.
FacetGroups facet_groups(const TriangleMesh& part, const PartFacets& facets);

}  // namespace endmill
