// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>

#include "endmill/mesh/detail/edge_uses.h"
#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// What a mesh is like. Points are equal if their numbers are: weld first, if not.
/// Triangles that repeat a corner count as degenerate and nowhere else.
struct MeshReport {
    std::size_t boundary_edges;                   ///< that belong to one triangle
    std::size_t non_manifold_edges;               ///< that belong to more than two
    std::optional<Edge> first_non_manifold_edge;  ///< lexicographically
    /// That belong to two triangles which run along it in the same direction, so that
    /// one of them is turned over.
    std::size_t inconsistent_edges;
    /// Pieces that hang together by edges, non-manifold ones included: pieces that only
    /// touch at a point are as many bodies.
    std::size_t components;
    /// Triangles whose corners lie on one line, exactly (collinear.h), or are less than
    /// three.
    std::size_t degenerate_triangles;
    /// Triangles with the three corners of one before them, in whatever order.
    std::size_t duplicate_triangles;
    double area;  ///< mm^2
    /// Whether there are edges, and none belongs to an odd number of triangles.
    bool closed;
    /// In mm^3, positive if the triangles are counter-clockwise seen from outside.
    /// Nothing unless every edge is run along as often in one direction as in the other.
    std::optional<double> volume;
};

/// All of it in time linear in the triangles if a point has a bounded number of them, and
/// else but for a logarithm; 28 bytes a triangle and 8 a point. Let S be the sum over all
/// triangles of the product of their sides at the first corner: the area is within 1e-15
/// S and the volume within 1e-15 S times the diagonal of the mesh's box.
MeshReport mesh_report(const TriangleMesh& mesh);

}  // namespace endmill
