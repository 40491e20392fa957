// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/bound/bound_problem.h"
#include "endmill/bound/path_bound.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// A lower bound of the numbers of moves and points of a path.
struct PointsBound {
    /// Straight moves at feed. A place that is plunged to and left again counts as one.
    double moves;
    double points;     ///< ends of these moves; retracts and rapids have none
    BoundGrade grade;  ///< Closed: certain up to rounding; Estimated: it may be too large
};

/// How few straight moves and points a path that covers a part can have. Its moves may leave
/// contact, and gouge the part by at most gamma.
///
/// The bound is certain in two cases, as far as the flank of the tool covers no more than
/// the ball:
/// - The part is one plane with a convex outline of straight sides, of least width W. The
///   cover of a move lies in a strip of the width w = 2 sqrt((R + gamma)^2 - (R - h)^2), and
///   strips that cover a convex set are together as wide as it (Bang). So there are at
///   least W / w moves.
/// - The part is one convex sphere of radius rho. The centre of the ball is at most rho + R + h
///   from that of the sphere if it covers anything, and at least rho + R - gamma. A straight
///   line is between both over an angle of 2 beta at most, with cos(beta) = (rho + R -
///   gamma) / (rho + R + h), so that a move covers at most 4 rho^2 beta sin(alpha) + 2 pi
///   rho^2 (1 - cos(alpha)), with alpha the half angle of the disc that the ball covers.
///
/// On other surfaces it is estimated: the integral of one over the greatest area that a move
/// covers at each place, by the curvatures there. A move is then no longer than the diagonal
/// of the part.
/// Source: docs/methods/path-length-bound.md, section 10.
/// \param surfaces, sides, problem as for path_bound; length and most_pieces play no role.
/// \throws DomainError as path_bound.
PointsBound points_bound(std::span<const Surface> surfaces, std::span<const double> sides,
                         const BoundProblem& problem);

/// The estimate, also where the bound is certain.
PointsBound estimated_points_bound(std::span<const Surface> surfaces,
                                   std::span<const double> sides,
                                   const BoundProblem& problem);

}  // namespace endmill
