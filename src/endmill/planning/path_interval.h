// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/planning/step_length.h"

namespace endmill {

/// How far apart neighbouring passes may lie.
struct PathInterval {
    double chord;      ///< l in mm, between the two contacts
    double projected;  ///< d in mm, of the chord onto the tangent at one of them
    double arc;        ///< in mm, along the circle that the section is taken for
    Angle half_angle;  ///< alpha, of the contacts and the scallop at the circle's centre
    LengthStatus status;
};

/// Largest distance between neighbouring passes of a ball that leaves a scallop no higher
/// than `scallop_height`, the section across the feed being a circle of constant
/// curvature.
///
/// The circle's centre, a ball's centre and the scallop's peak span a triangle with sides
/// |rho| + R, |rho| + h and R; half the angle between the passes follows from the law of
/// cosines. Written with g = sqrt(h (2R - h) / ((1 + kR)(1 + kh))), the chord
///
///     l = 2 g sqrt(1 - k^2 g^2 / 4)
///
/// needs no division by k and does not cancel; the printed form loses all digits at large
/// radii of curvature.
/// Source: [KimChoi, eq. (4), (5), (14)]; paper/notes/path-interval.md derives the form.
///
/// Clamped: where no two neighbouring balls leave a scallop so high, to the highest one
/// that they do leave; where the contacts would stand more than 90 degrees apart (alpha
/// above 45, where d falls again), to those. Unlimited: the whole concavity lies within
/// `scallop_height` of one ball.
///
/// \param curvature      k in 1/mm across the feed, positive where the part is convex.
/// \param scallop_height h in mm along the normal.
/// \throws DomainError unless 0 < h < 2R and k is finite.
/// \throws GeometryError if 1 + kR <= 0: the ball does not fit the concavity.
/// Relative error below 1e-14 while 1 + kR and 1 + kh stay above 0.01.
PathInterval path_interval(const BallCutter& cutter, double curvature,
                           double scallop_height);

/// Greatest scallop that neighbouring passes of `cutter` leave at all, in mm: beyond it
/// the balls no longer meet above the circle, h_max = 2R / (1 + sqrt(1 + 2kR)).
/// Infinite if 1 + 2kR < 0: the concavity closes around the ball.
/// \throws DomainError unless k is finite; GeometryError if 1 + kR <= 0.
/// Relative error below 1e-14 while 1 + 2kR stays above 0.01.
/// Source: [KimChoi, eq. (14)] at its turning point, derived in
/// paper/notes/path-interval.md.
double highest_scallop(const BallCutter& cutter, double curvature);

/// Scallop in mm that passes of `cutter` leave whose contacts lie `interval` apart on a
/// circle: the inverse of path_interval where that is Ok.
/// Source: [KimChoi, fig. 5, eq. (14)], solved for h in paper/notes/path-interval.md.
///
/// \param curvature k in 1/mm across the feed, positive where the part is convex.
/// \param interval  l in mm, the chord between contacts.
/// \throws DomainError unless 0 < l and k is finite.
/// \throws GeometryError if the ball does not fit (1 + kR <= 0), if l exceeds the circle
/// (|k| l > 2), or if the balls do not meet ((1 + kR) l > 2R).
/// Relative error below 1e-13 for 1 + kR >= 0.01 and intervals from 1e-6 R to 0.99 of the
/// longest; it grows where the balls barely meet.
double scallop_height(const BallCutter& cutter, double curvature, double interval);

}  // namespace endmill
