// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/detail/cross_section.h"
#include "endmill/planning/iso_parametric.h"

namespace endmill {

/// Height in mm of the cusp that a ball leaves between two contacts of neighbouring
/// passes.
///
/// The two balls intersect in a circle. The check plane of the first contact (through the
/// contact, normal to the feed) cuts this circle in two points; the cusp is the lower
/// one. Its height is its distance from the surface, found by Newton's method. The
/// formula of the path interval is not used, so the result is an independent check of it.
///
/// \param frame the first contact and its feed direction.
/// \param partner parameters of the second contact.
/// \param side +1 or -1, from tool_side_sign.
/// \return the height; on a circular section it equals the scallop height that the
///         interval was computed for. Not a number if the balls do not intersect in the
///         check plane, or if Newton's method does not converge within 30 steps.
double scallop_between(const Surface& surface, const BallCutter& ball,
                       const FeedFrame& frame, const SurfacePoint& partner, double side);

/// Cusp height in mm between the governing point of each pass of `plan` and its partner
/// on the next pass, in the order of the passes. Passes without a governing point are
/// left out.
/// \param direction direction of the passes.
std::vector<double> governing_scallops(const Surface& surface, const BallCutter& ball,
                                       const IsoParametricPlan& plan,
                                       Parameter direction);

}  // namespace endmill
