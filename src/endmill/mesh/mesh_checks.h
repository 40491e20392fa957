// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// \file
/// Reports on the quality of a mesh: topology, degenerate triangles, area and volume.
///
/// Two corners are the same point only if their numbers are equal. If each triangle has
/// points of its own, the mesh must be welded first (detail/weld.h).

/// Topology and measures of a mesh. A triangle that repeats a corner counts as degenerate
/// and does not contribute to any other number.
struct MeshReport {
    std::size_t boundary_edges;      ///< edges of one triangle
    std::size_t non_manifold_edges;  ///< edges of more than two triangles
    /// The lexicographically least of these edges.
    std::optional<MeshEdge> first_non_manifold_edge;
    /// Edges along which their two triangles run in the same direction: the orientations
    /// of the two triangles disagree.
    std::size_t inconsistent_edges;
    /// Number of pieces connected by edges, non-manifold edges included. Pieces that
    /// touch only at a point count separately.
    std::size_t components;
    /// Triangles that repeat a corner or whose corners are collinear; decided exactly by
    /// `are_collinear`.
    std::size_t degenerate_triangles;
    /// Triangles that have the same three corners, in any order, as an earlier one.
    std::size_t duplicate_triangles;
    /// The ends of all edges that do not belong to exactly two triangles in opposite
    /// directions; rising. All boundary loops run through these points.
    std::vector<std::int32_t> points_at_breaks;
    double area;  ///< mm^2
    /// Whether there are edges and every edge belongs to an even number of triangles.
    bool closed;
    /// In mm^3, positive if the triangles are counter-clockwise seen from outside. Empty
    /// unless the triangles run along every edge equally often in both directions.
    std::optional<double> volume;
};

/// Computes the report.
///
/// Takes linear time if the number of triangles at a point is bounded, else n log n, and
/// 28 bytes a triangle and 8 a point; 40 a triangle and 12 a point if the triangles are in
/// no order of place. Let S be the sum, over all triangles, of the
/// product of the two sides at the first corner. The area is within 1e-15 S, and the
/// volume within 1e-15 S times the diagonal of the mesh's bounding box.
MeshReport mesh_report(const TriangleMesh& mesh);

/// A closed chain of boundary edges.
struct BoundaryLoop {
    /// Numbers of the points, starting with the lowest, in the direction in which the
    /// triangles run: an outer rim counter-clockwise seen from outside, a hole clockwise.
    std::vector<std::int32_t> points;
    double length;  ///< mm
};

/// The boundary loops of a mesh, in the order of their first points.
///
/// The mesh is first cut into manifold pieces: along edges of more than two triangles,
/// along inconsistent edges, and at points where several fans of triangles meet. Both
/// sides of a cut that stays open are boundaries of the pieces. On a non-manifold mesh,
/// loops can therefore pass along edges that are not counted in `boundary_edges`.
/// Triangles that repeat a corner are left out.
/// \throws DomainError if there are more than 715 827 882 triangles.
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh);

/// The same in less time.
/// \param points_at_breaks of the report on the mesh.
std::vector<BoundaryLoop> boundary_loops(const TriangleMesh& mesh,
                                         std::span<const std::int32_t> points_at_breaks);

}  // namespace endmill
