// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// The triangles that a picture shows in place of a mesh.
struct DrawnMesh {
    std::vector<Triangle> triangles;  ///< by the points of the mesh
    std::vector<std::size_t> facets;  ///< of each triangle: the facet that it stands for
};

/// The triangles to draw: all of them, or a coarser mesh if there are more than `most`.
///
/// 1. If there are more than twice `most`, the points in each cell of a grid are merged
///    into the first of them. This is fast and loses detail evenly. The finest of eight
///    grids that leaves at most twice `most` triangles is used.
/// 2. The rest is decimated to `most` by edge collapses (`decimated`), which keeps the
///    shape.
/// 3. If too many triangles remain, because they are not connected, some are left out at
///    equal steps of their numbers.
/// \param points    in mm.
/// \param triangles numbers of points.
/// \param most      at least 1.
/// \throws DomainError if `most` is 0.
DrawnMesh drawn_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     std::size_t most);

}  // namespace endmill
