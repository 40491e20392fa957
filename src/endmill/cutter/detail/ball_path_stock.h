// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

// The stock that a cutter leaves when it follows the offset of a ball of the same radius
// R. The ball would touch the part everywhere. With the reference point on the ball's
// centre, a cutter with a flat bottom leaves stock; with the tip on the ball's tip it
// gouges. Positive results are remaining stock, negative ones the depth of a gouge, in mm
// along the normal.
//
// The outline of the cutter and the circle are sampled at n intervals. At a slope a, the
// exact values are (R - r) (1 - sin a) for the reference points and -(R - r) (sin a + cos
// a - 1) for the tips, on a plane and in a valley. The results are never below them by
// more than rounding. On a plane the excess is below R^2 / (2 r n^2 cos^2 a), to first
// order, and 0 for a flat end mill. In a valley of radius V, (V - R) pi^2 / (8 n^2) is
// added to that.
// Source: [JangKimJeong, fig. 2].

/// The stock on a plane: the lowest outline of the cutter over one point of the plane,
/// over all positions of the cutter on the ball's path.
/// \param cutter of the ball's radius.
/// \param equated the point of the cutter that follows that of the ball.
/// \param slope of the plane against the horizontal, from 0 to below 90 degrees.
/// \param samples number of intervals between the positions, at least 1.
double stock_on_plane(const Cutter& cutter, ControlPoint equated, Angle slope,
                      int samples);

/// The stock at the given slope of a round valley, along which the ball's centre moves on
/// a circle of radius `valley_radius` - R.
/// \param cutter, equated, slope as in stock_on_plane.
/// \param valley_radius in mm, above R.
/// \param samples number of intervals on the path and on the outline, at least 1.
double stock_in_valley(const Cutter& cutter, ControlPoint equated, Angle slope,
                       double valley_radius, int samples);

}  // namespace endmill
