// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh whose equal, or nearly equal, points were made one.
struct WeldedMesh {
    /// All triangles given, in the same order, those that welding left no area included.
    /// Points in the order in which the triangles given, or the points given, first come
    /// to them.
    TriangleMesh mesh;
    std::size_t welded_points;  ///< corners or points given, less points of the mesh
    double largest_move;        ///< mm, of a point to the one that stands for it
};

/// The mesh of triangles that stand alone, as an STL file has them. Corners with equal
/// coordinates (0 equals -0, and becomes it) are one point; with a tolerance, so are
/// points that a chain of others joins by steps no longer than it.
///
/// Guaranteed with a tolerance: points within it of each other become one, so that all
/// points of the mesh are further apart; which do does not depend on the order of the
/// triangles, and neither do the points that stand for them, the lexicographically least
/// (x, then y, then z) of each chain. A point moves at most by the length of its chain;
/// `largest_move` tells how far that was. A step's length is rounded to 1e-15 of itself.
///
/// Exact welding takes time linear in the corners and, while it works, at most 72 bytes a
/// point of the result beside it. A tolerance takes at most 200 bytes a point more, and
/// time that grows with the square of the number of points within a step of each other.
///
/// \param soup      corners in mm, counter-clockwise seen from outside.
/// \param tolerance in mm; 0 welds what is equal.
/// \throws DomainError if a corner is not finite, there are more than 715 827 882
///         triangles, or the tolerance is neither 0 nor between 1e-12 of the largest
///         coordinate and infinity.
WeldedMesh weld(std::span<const std::array<Vec3, 3>> soup, double tolerance = 0);

/// The same of a mesh. Points that no triangle names are welded like others.
WeldedMesh weld(const TriangleMesh& mesh, double tolerance = 0);

}  // namespace endmill
