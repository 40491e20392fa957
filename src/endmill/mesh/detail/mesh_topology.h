// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// Pieces of a mesh that hang together by edges.
struct MeshComponents {
    std::size_t count;
    /// For each triangle the number of its piece, from 0 in the order of their first
    /// triangles.
    std::vector<std::int32_t> of_triangle;
};

/// What lies beside what on a manifold mesh: half-edges, 54 bytes a triangle, and as much
/// again while it is made. An immutable value, cheap to copy; the mesh is needed no longer
/// once it is made.
class MeshTopology {
public:
    /// \throws GeometryError, which names the place, if a triangle repeats a corner, an
    ///         edge belongs to more than two triangles or is run along twice in the same
    ///         direction, or a point joins triangles that do not hang together by edges
    ///         at it. mesh_repair.h may help.
    /// \throws DomainError if there are more than 715 827 882 triangles.
    explicit MeshTopology(const TriangleMesh& mesh);

    /// The triangles beyond the sides 0-1, 1-2 and 2-0 of a triangle, nothing where it is
    /// at the boundary.
    /// \throws DomainError if there is no such triangle.
    std::array<std::optional<std::size_t>, 3> neighbours(std::size_t triangle) const;

    /// The points that an edge joins to a point, counter-clockwise seen from outside:
    /// around a boundary point from one boundary neighbour to the other, around others
    /// from the lowest. Empty if no triangle has the point.
    /// \throws DomainError if there is no such point.
    std::vector<std::int32_t> one_ring(std::int32_t point) const;

    /// The points of each boundary, in the direction in which the triangles run along it:
    /// an outer rim counter-clockwise seen from outside, a hole clockwise. A loop begins
    /// with its lowest point, and loops are in the order of these.
    std::vector<std::vector<std::int32_t>> boundary_loops() const;

    /// The pieces that hang together over edges.
    MeshComponents components() const;

private:
    struct HalfEdges;
    std::shared_ptr<const HalfEdges> half_edges_;
};

}  // namespace endmill
