// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/process/ball_engagement.h"
#include "endmill/process/detail/engaged_region.h"

namespace endmill {

/// 2 pi times I1 … I8, or a border's share of them.
using CoefficientSums = std::array<double, 8>;

/// What the borders but the stock's top add: the integrals of g_k(azimuth) h_k(latitude)
/// over the azimuth, h_k that of the weight over the latitude from the tip. By a
/// Gauss-Kronrod rule of 15 nodes; a stretch is halved until no sum differs from that of
/// the Gauss rule of 7 nodes within by more than `tolerance`. The integrands are bounded,
/// also at the tip.
/// Source: derived in paper/notes/ball-engagement.md, section 3.
CoefficientSums border_integrals(const EngagedRegion& region, ChipModel chip,
                                 double tolerance);

/// h(latitude) for a weight sin^2: the integral from the tip, (d - sin d cos d) / 2, over
/// sin(d) (1 - cos(d)). An analytic function of 1 - cos(d), from 0 to 1: relative error
/// below 1e-15.
double torque_height_share(double one_minus_cosine);

}  // namespace endmill
