// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"

/// \file
/// The stock that a cutter leaves on the path of a ball of the same radius R, which would
/// touch the part everywhere. Results are in mm along the normal: positive for remaining
/// stock, negative for the depth of a gouge.
///
/// At a slope a, the exact value is (R - r) (1 - sin a) if the reference points follow the
/// ball's centre, and -(R - r) (sin a + cos a - 1) if the tips follow its tip. Sampling at
/// n intervals adds at most, to first order, R^2 / (2 r n^2 cos^2 a) on a plane (0 for a
/// flat end mill), and (V - R) pi^2 / (8 n^2) more in a valley of radius V. It never
/// subtracts more than rounding.
/// Source: [JangKimJeong, fig. 2].

namespace endmill {

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
