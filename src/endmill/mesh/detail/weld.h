// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "endmill/mesh/triangle_mesh.h"

namespace endmill {

/// A mesh in which equal or nearly equal points have become one point.
struct WeldedMesh {
    /// All given triangles in the same order, also those that lost their area. The points
    /// are in the order in which the given triangles, or the given points, first use
    /// them.
    TriangleMesh mesh;
    /// Number of given corners or points, less the points of `mesh`.
    std::size_t welded_points;
    /// In mm: largest distance of a given point from the point that replaces it.
    double largest_move;
};

/// Makes a mesh of separate triangles, such as an STL file contains. Corners with equal
/// coordinates become one point; 0 and -0 are equal. With a tolerance, points become one
/// that are connected by a chain of points with steps no longer than the tolerance.
///
/// With a tolerance it is guaranteed that all points of the result are further apart than
/// the tolerance. Which points become one does not depend on the order of the triangles.
/// The point that replaces a chain is its lexicographically least one (x, then y, then
/// z). A point moves by at most the length of its chain; `largest_move` is how far that
/// was. The length of a step has a relative rounding error of 1e-15.
///
/// Exact welding takes linear time and, while it works, at most 72 bytes for each point
/// of the result, or 23 for each given triangle or 46 for each given point if that is
/// more. A tolerance takes at most 200 bytes a point more, and time that grows
/// with the square of the number of points within one step of each other.
///
/// \param soup corners in mm, counter-clockwise seen from outside.
/// \param tolerance in mm; 0 welds equal points only.
/// \throws DomainError if a corner is not finite, there are more than 715 827 882
///         triangles, or the tolerance is neither 0 nor a finite number of at least 1e-12
///         of the largest coordinate.
WeldedMesh weld(std::span<const std::array<Vec3, 3>> soup, double tolerance = 0);

/// The same for a mesh. Points that no triangle uses are welded like all others.
WeldedMesh weld(const TriangleMesh& mesh, double tolerance = 0);

}  // namespace endmill
