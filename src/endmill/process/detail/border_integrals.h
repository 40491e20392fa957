// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/process/detail/engaged_region.h"

namespace endmill {

/// 2 pi times I1 to I8, or the contribution of a border to them.
using CoefficientSums = std::array<double, 8>;

/// Contribution of all borders except the stock's top: the integrals over the azimuth of
/// g_k(azimuth) h_k(latitude), where h_k is the integral of the weight over the latitude
/// from the tip. The integrands are bounded, also at the tip.
///
/// An arc is integrated by the Gauss-Kronrod rule of 15 nodes. It is halved until no sum
/// differs by more than `tolerance` from that of the embedded Gauss rule of 7 nodes.
/// Source: derived in paper/notes/ball-engagement.md, section 3.
CoefficientSums border_integrals(const EngagedRegion& region, ChipModel chip,
                                 double tolerance);

/// h(latitude) for the weight sin^2, divided by sin(d) (1 - cos(d)): the integral of
/// sin^2 from the tip is (d - sin d cos d) / 2. The quotient is an analytic function of 1
/// - cos(d), which is evaluated by a series.
/// \param one_minus_cosine 1 - cos(d), from 0 to 1.
/// Relative error below 1e-15.
double torque_height_share(double one_minus_cosine);

}  // namespace endmill
