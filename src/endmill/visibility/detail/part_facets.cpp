// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/part_facets.h"

#include <array>

#include <Eigen/Geometry>

#include "endmill/core/orientation.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// The sides are normalised first, so that the cross product of tiny or huge facets stays
// in the range of a double.
Vec3 normal_of(const std::array<Vec3, 3>& corners)
{
    const auto& [a, b, c] = corners;
    return (b - a)
        .stableNormalized()
        .cross((c - a).stableNormalized())
        .stableNormalized();
}

}  // namespace

PartFacets part_facets(const TriangleMesh& part)
{
    PartFacets facets;
    facets.normals.assign(part.triangles().size(), Vec3::Zero());
    facets.centroids.resize(part.triangles().size());
    parallel_for(facets.normals.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t facet = begin; facet < end; ++facet) {
            const auto corners = part.corners(facet);
            facets.centroids[facet] = corners[0] / 3 + corners[1] / 3 + corners[2] / 3;
            if (!are_collinear(corners[0], corners[1], corners[2]))
                facets.normals[facet] = normal_of(corners);
        }
    });
    for (std::size_t facet = 0; facet < facets.normals.size(); ++facet)
        if (!facets.has_area(facet))
            facets.dropped.push_back(facet);
    return facets;
}

}  // namespace endmill
