// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh cut into manifold pieces, as half-edge structures need them: an edge belongs to
/// one triangle, or to two that run along it in opposite directions, and the triangles at
/// a point form one fan.
struct ManifoldPieces {
    std::vector<Triangle> triangles;  ///< by the points of the pieces
    /// Of each point of the pieces: its point in the mesh.
    std::vector<std::int32_t> points;
    /// Of each triangle of the pieces: its number in the mesh, rising.
    std::vector<std::int32_t> source_triangles;
    /// Whether a cut was not enough, so that triangles were detached from all others.
    bool has_detached = false;
};

/// Cuts `mesh` into manifold pieces by giving each fan of triangles a copy of its point.
///
/// The mesh is cut along edges of more than two triangles, along edges whose two
/// triangles run in the same direction, and at points where several fans meet. Triangles
/// that repeat a corner are left out. A manifold, consistently oriented mesh stays as it
/// is. Time grows as n log n with the number n of triangles, except for a mesh with a
/// very tangled neighbourhood, which takes several passes.
/// \throws DomainError if there are more than 715 827 882 triangles.
ManifoldPieces manifold_pieces(const TriangleMesh& mesh);

}  // namespace endmill
