// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"
#include "endmill/planning/step_length.h"

/// \file
/// The relation between the interval of neighbouring passes and the height of the scallop
/// between them, for a ball on a surface whose section across the feed is a circle.

namespace endmill {

/// Distance between neighbouring passes, also called pick feed.
struct PathInterval {
    double chord;      ///< l in mm, between the two contacts
    double projected;  ///< d in mm, projection of the chord on the tangent at one contact
    double arc;        ///< length in mm of the circle's arc between the contacts
    Angle half_angle;  ///< alpha: half the angle between the contacts, from the centre
    LengthStatus status;  ///< whether the formula or a limit determined the values
};

/// Largest distance between neighbouring passes of a ball that leaves a scallop no higher
/// than `scallop_height`. The section of the part across the feed is taken as a circle of
/// constant curvature.
///
/// The centre of the circle, the centre of a ball and the peak of the scallop form a
/// triangle with sides |rho| + R, |rho| + h and R. The law of cosines gives half the
/// angle between the contacts. With g = sqrt(h (2R - h) / ((1 + kR)(1 + kh))), the chord
///
///     l = 2 g sqrt(1 - k^2 g^2 / 4)
///
/// has no division by k and no cancellation. The form that the paper prints loses all
/// digits at large radii of curvature.
/// Source: [KimChoi, eq. (4), (5), (14)]; derived in paper/notes/path-interval.md,
/// section 2, and paper/notes/path-interval.md, section 3.
///
/// The status is Clamped in two cases:
/// - Neighbouring balls never leave a scallop of this height. The highest scallop that
///   they leave replaces it.
/// - alpha exceeds 45 degrees, beyond which d decreases. It becomes 45 degrees.
///
/// The status is Unlimited if the whole concavity lies within `scallop_height` of one
/// ball.
///
/// \param cutter         the ball, radius R.
/// \param curvature      k in 1/mm across the feed, positive where the part is convex.
/// \param scallop_height h in mm along the normal.
/// \throws DomainError unless 0 < h < 2R and k is finite.
/// \throws GeometryError if 1 + kR <= 0: the ball does not fit the concavity.
///
/// Relative error below 1e-14 while 1 + kR and 1 + kh stay above 0.01.
PathInterval path_interval(const BallCutter& cutter, double curvature,
                           double scallop_height);

/// Height in mm of the highest scallop that neighbouring passes of `cutter` can leave,
/// h_max = 2R / (1 + sqrt(1 + 2kR)). At a wider interval the balls no longer meet above
/// the circle. The result is infinite if 1 + 2kR < 0: the concavity closes around the
/// ball.
/// \param cutter    the ball, radius R.
/// \param curvature k in 1/mm across the feed, positive where the part is convex.
/// \throws DomainError unless k is finite.
/// \throws GeometryError if 1 + kR <= 0: the ball does not fit the concavity.
///
/// Relative error below 1e-14 while 1 + 2kR stays above 0.01.
/// Source: [KimChoi, eq. (14)] at its turning point, derived in
/// paper/notes/path-interval.md, section 5.
double highest_scallop(const BallCutter& cutter, double curvature);

/// Height in mm of the scallop between passes of `cutter` whose contacts lie `interval`
/// apart on a circle. It is the inverse of path_interval if the status of the interval is
/// Ok.
/// Source: [KimChoi, fig. 5, eq. (14)], solved for h in paper/notes/path-interval.md,
/// section 7.
///
/// \param cutter    the ball, radius R.
/// \param curvature k in 1/mm across the feed, positive where the part is convex.
/// \param interval  l in mm, the chord between contacts.
/// \throws DomainError unless 0 < l and k is finite.
/// \throws GeometryError if the ball does not fit (1 + kR <= 0), if l exceeds the
/// circle's diameter (|k| l > 2), or if the balls do not meet ((1 + kR) l > 2R).
///
/// Relative error below 1e-13 for 1 + kR >= 0.01 and intervals from 1e-6 R to 0.99 of the
/// longest; it grows where the balls barely meet.
double scallop_height(const BallCutter& cutter, double curvature, double interval);

/// Largest distance in mm between parallel passes on a horizontal plane that leaves a
/// scallop no higher than `scallop_height`. The corners of a flat or bull-nose cutter cut
/// as a ball of the corner radius, and the flat bottom adds its width.
/// \param cutter         upright; corner radius r.
/// \param scallop_height h in mm.
/// \throws DomainError unless 0 < h < 2r; therefore for every flat cutter.
///
/// Relative error below 1e-14.
double level_path_interval(const Cutter& cutter, double scallop_height);

/// Height in mm of the scallop on a horizontal plane between parallel passes of an upright
/// cutter. It is the inverse of level_path_interval where the corners meet.
/// \param cutter   upright. \param interval in mm, finite.
/// \return 0 if the flat bottoms touch or overlap; otherwise nothing if the interval is at
///         least the diameter, where the corners do not meet.
/// \throws DomainError unless the interval is finite.
///
/// Relative error below 1e-13 for a ball and intervals up to 0.99 of the diameter. A
/// bull-nose cutter loses the digits that the interval shares with its flat bottom.
std::optional<double> level_scallop_height(const Cutter& cutter, double interval);

}  // namespace endmill
