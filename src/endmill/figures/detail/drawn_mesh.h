// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Triangles that a picture shows of a mesh.
struct DrawnMesh {
    std::vector<Triangle> triangles;  ///< by the mesh's points
    std::vector<std::size_t> facets;  ///< of the mesh, one a triangle: what it stands for
};

/// All of `triangles`, or if there are more than `most`, a coarser mesh in their place: the
/// points of each cube of a grid become the first of them, and of triangles that thereby
/// become the same the first is kept. The grid is the finest of a few that leaves no more
/// than `most`; of a mesh that none of them does, every so many.
/// \param points in mm. \param most at least 1.
/// \throws DomainError if `most` is 0.
DrawnMesh drawn_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     std::size_t most);

}  // namespace endmill
