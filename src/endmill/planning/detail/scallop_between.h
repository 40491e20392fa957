// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {

/// Height in mm of the cusp that two balls leave between them, in place at two contacts:
/// the lower of the two points that both spheres and the check plane of the first contact
/// share, measured along the normal of the true surface. Nothing here uses the formula of
/// the path interval.
///
/// \param frame the first contact and its feed.
/// \param partner the second one.
/// \param side from tool_side_sign.
/// \return on a circular section the scallop height; not a number if the spheres do not
/// meet in the plane or the surface has no point below the cusp.
double scallop_between(const Surface& surface, const BallCutter& ball,
                       const FeedFrame& frame, const SurfacePoint& partner, double side);

/// The cusps between the governing point and its partner of every pass of `plan` that has
/// them, in order.
/// \param direction of the passes.
std::vector<double> governing_scallops(const Surface& surface, const BallCutter& ball,
                                       const IsoParametricPlan& plan,
                                       Parameter direction);

/// The middle value. \pre not empty.
double median(std::vector<double> values);

}  // namespace endmill
