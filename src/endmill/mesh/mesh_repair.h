// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh from which triangles were removed. Points keep their numbers.
struct CleanedMesh {
    TriangleMesh mesh;                 ///< the remaining triangles, in the same order
    std::size_t degenerate_triangles;  ///< number of removed triangles without area
    std::size_t duplicate_triangles;   ///< number of removed triangles with area
};

/// Removes triangles whose corners are collinear, decided exactly by `are_collinear`, and
/// triangles that have the same three corners, in any order, as an earlier one.
///
/// If the corners of a removed triangle without area were three different points, its
/// removal may leave a T-junction: one edge that faces two collinear edges.
CleanedMesh without_degenerate_or_duplicate(const TriangleMesh& mesh);

/// A mesh in which the orientation of triangles was reversed.
struct OrientedMesh {
    TriangleMesh mesh;  ///< all given triangles, in the same order
    /// Number of triangles whose second and third corner were exchanged.
    std::size_t turned_triangles;
    /// Number of pieces that cannot be oriented, and were left unchanged.
    std::size_t unorientable;
};

/// Orients every piece of a mesh consistently. A piece is connected by edges of exactly
/// two triangles.
///
/// - An open piece keeps the orientation of the majority of its triangles, or of its
///   first one if there is none.
/// - A closed piece that no other piece encloses is oriented outwards.
/// - A closed piece inside another may be a cavity or a body of its own. It is oriented
///   like an open one, and reversed together with the outermost piece around it.
/// - A closed piece whose volume is not above its rounding error counts as open.
///
/// A piece encloses another if it winds around one of the other's points. It is not
/// defined whether pieces that intersect enclose each other. Takes time of the order n
/// log n for n triangles. Each pair of a closed piece and another piece in its bounding
/// box adds log n as a rule, and n^(5/6) at worst.
OrientedMesh oriented(const TriangleMesh& mesh);

}  // namespace endmill
