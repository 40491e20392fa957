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

/// Up to eight facets close to each other, one for each lane of a SIMD register.
struct FacetGroup {
    int count;  ///< number of facets; further lanes repeat the last facet
    std::array<std::int32_t, float_lanes> facet;  ///< numbers of the facets
    /// [corner]: point numbers.
    std::array<std::array<std::int32_t, float_lanes>, 3> corner;
};

/// The facets of a part that have an area, in groups that are close to each other in
/// space and in memory, whatever the order of the part's facets is.
struct FacetGroups {
    std::vector<Vec3> points;  ///< mm, points of the part in the order of their first use
    std::vector<FacetGroup> groups;
    std::vector<Vec3> centroids;  ///< mm, of all facets in the order of the groups
};

/// Groups the facets of a part.
/// \param part facets in mm. \param facets properties of the facets of `part`.
FacetGroups facet_groups(const TriangleMesh& part, const PartFacets& facets);

}  // namespace endmill
