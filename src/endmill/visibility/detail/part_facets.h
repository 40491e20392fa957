// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// What the facets of a part are like, each by itself.
struct PartFacets {
    std::vector<Vec3> normals;    ///< unit, outward; 0 without area
    std::vector<Vec3> centroids;  ///< mm, (a + b + c) / 3 rounded
    std::vector<std::size_t>
        dropped;  ///< without area, decided exactly (are_collinear); in order

    /// Whether its corners lie on no line. \pre the facet exists.
    bool has_area(std::size_t facet) const { return !normals[facet].isZero(0); }
};

/// Normals are off by 1e-15 at most, times the square of the longest side by the area.
PartFacets part_facets(const TriangleMesh& part);

}  // namespace endmill
