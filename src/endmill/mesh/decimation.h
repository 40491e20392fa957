// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A coarser mesh in place of a given one.
struct DecimatedMesh {
    TriangleMesh
        mesh;  ///< its points are some of the given ones, unmoved and in their order
    std::vector<std::int32_t>
        source_points;  ///< of each point: its number in the given mesh
    /// Of each triangle: the number of the given triangle that it replaces, rising. Each
    /// triangle covers about the place of the one that it replaces.
    std::vector<std::int32_t> source_triangles;
};

/// Reduces a mesh to about `most_triangles` triangles for a coarse preview.
///
/// Edges are collapsed into one of their ends, the edge of least cost first. The cost is the
/// quadric error: the sum of squared distances of the remaining end from the planes of all
/// triangles collapsed into it so far, each weighted by its area, and of the planes that
/// stand on boundary edges. So flat regions lose triangles first, and a plane part of the
/// mesh stays plane with a straight boundary. A collapse that would turn a triangle by more
/// than about 78 degrees, or change the topology of a piece, is not made.
/// Source: [GarlandHeckbert, sections 4 and 6], with the ends of an edge as the only places.
///
/// The mesh is cut into manifold pieces first (see `boundary_loops`), and copies of a point
/// become one again in the result. Accuracy: none is guaranteed; the result is for pictures.
/// Deterministic. Takes 10 to 20 us and 150 bytes a triangle of the given mesh.
///
/// \param most_triangles number of triangles to stop at. A mesh that has no more is returned
///        as it is. The result has more if no further collapse is possible.
/// \throws DomainError if there are more than 715 827 882 triangles.
DecimatedMesh decimated(const TriangleMesh& mesh, std::size_t most_triangles);

}  // namespace endmill
