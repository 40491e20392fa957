// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The triangles that a figure shows in place of a mesh.
struct DrawnMesh {
    std::vector<Triangle> triangles;  ///< with indices of the mesh's points
    std::vector<std::size_t> facets;  ///< for each triangle the facet that it represents
};

/// The triangles to draw: all of them if there are at most `most`, else a coarser mesh by
/// vertex clustering. Points in the same cube of a grid are replaced by the first of
/// them, and of triangles that become equal the first is kept. The finest grid of a fixed
/// list is used that leaves at most `most` triangles. If no grid does, every n-th
/// triangle is drawn.
/// \param points in mm. \param most at least 1.
/// \throws DomainError if `most` is 0.
DrawnMesh drawn_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     std::size_t most);

}  // namespace endmill
