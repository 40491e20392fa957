// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Normals and centroids of a part's facets.
struct PartFacets {
    std::vector<Vec3> normals;    ///< unit, outward; 0 for a facet without area
    std::vector<Vec3> centroids;  ///< mm, (a + b + c) / 3 rounded
    /// Facets with exactly collinear corners (are_collinear), ascending.
    std::vector<std::size_t> dropped;

    /// Tests whether a facet has an area. \pre the facet exists.
    bool has_area(std::size_t facet) const { return !normals[facet].isZero(0); }
};

/// Computes normals and centroids. The error of a normal is at most 1e-15 times the
/// square of the facet's longest side divided by its area.
PartFacets part_facets(const TriangleMesh& part);

}  // namespace endmill
