// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A coarser mesh that replaces a given one.
struct DecimatedMesh {
    /// The coarse mesh. Its points are a subset of the given points, in the same order.
    TriangleMesh mesh;
    /// For each point its number in the given mesh.
    std::vector<std::int32_t> source_points;
    /// For each triangle the number of the given triangle that it replaces, rising. Both
    /// triangles are at about the same place.
    std::vector<std::int32_t> source_triangles;
};

/// Reduces a mesh to about `most_triangles` triangles for a coarse preview.
///
/// Edges are collapsed into one of their ends, the edge of least cost first. The cost is
/// the quadric error of the remaining end: the sum of its squared distances from the
/// planes of all triangles collapsed into it so far, each weighted by its area, and from
/// the planes perpendicular to the mesh at boundary edges. Flat regions therefore lose
/// triangles first, and a plane region of the mesh stays plane with a straight boundary.
/// A collapse is rejected if it would rotate a triangle by more than about 78 degrees or
/// change the topology of a piece.
/// Source: [GarlandHeckbert, sections 4 and 6], where only the ends of an edge are
/// candidates.
///
/// The mesh is first cut into manifold pieces (see `boundary_loops`). Copies of a point
/// that this makes are merged in the result. Accuracy: none is guaranteed; the result is
/// for pictures. Deterministic. Takes 10 to 20 us and 150 bytes a triangle of the given
/// mesh.
///
/// \param most_triangles number of triangles at which the reduction stops. A mesh with at
///        most this number is returned unchanged. The result has more triangles if no
///        further collapse is possible.
/// \throws DomainError if there are more than 715 827 882 triangles.
DecimatedMesh decimated(const TriangleMesh& mesh, std::size_t most_triangles);

}  // namespace endmill
