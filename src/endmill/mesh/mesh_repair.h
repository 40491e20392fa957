// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh of which triangles were left out. Points keep their numbers.
struct CleanedMesh {
    TriangleMesh mesh;                 ///< the other triangles, in the same order
    std::size_t degenerate_triangles;  ///< left out
    std::size_t duplicate_triangles;   ///< left out, of those with an area
};

/// The mesh without triangles whose corners lie on one line, exactly (collinear.h), and
/// without those that have the three corners of one before them, in whatever order.
/// A degenerate triangle with three different corners leaves a slit of no width: an edge
/// on one side of which stand two.
CleanedMesh without_degenerate_or_duplicate(const TriangleMesh& mesh);

/// A mesh of which triangles were turned over.
struct OrientedMesh {
    TriangleMesh mesh;             ///< all triangles given, in the same order
    std::size_t turned_triangles;  ///< whose second and third corner changed places
    std::size_t unorientable;      ///< pieces left as they were: they have one side only
};

/// The mesh with every piece consistently oriented, as far as that can be told without
/// guessing. A piece hangs together by edges of exactly two triangles.
///
/// * An open piece keeps the orientation of most of its triangles; if it is halved, that
///   of its first.
/// * A closed piece that no other encloses is turned outwards.
/// * A closed piece inside another may be a cavity or a body; it is made consistent like
///   an open one, and turned over when the outermost piece around it is.
/// * A closed piece without a volume that is more than rounding is taken for an open one.
///
/// Which pieces enclose which is told by how often a piece winds around a point of the
/// other; pieces that cut each other enclose each other or not, as that point does.
/// Time: n log n for n triangles; for each closed piece, and each other in whose box it
/// lies, at most of the order of n^(5/6) more, commonly log n.
OrientedMesh oriented(const TriangleMesh& mesh);

}  // namespace endmill
