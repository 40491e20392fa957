// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/planning/economy.h"
#include "endmill/strategy/detail/part_samples.h"

namespace endmill {

/// Values on the samples of a part whose level lines are good passes.
///
/// Near a contact the ball covers about an ellipse with the half axes
/// sqrt(2 h R / (1 + R k_i)) along the principal directions. A feed along one direction
/// sweeps the width of that ellipse across the feed; per unit of tip travel it sweeps less
/// where the part is convex along the feed. The function minimises
///
///     sum over triangles of area |grad f - n / s|^2,
///
/// where n is the direction across the feed and s the swept width divided by its value on a
/// plane, so that equal steps of f are about equally wide strips. At first n is the
/// direction of the widest strip, smoothed as a field of lines; then it is that of the
/// gradient, for a few rounds.
/// Source: docs/methods/field-passes.md, section 2.
/// \param samples  the part.
/// \param cutter   the ball, radius R.
/// \param height   h, mm.
/// \param distance whether contact travel or tip travel shall be short.
/// \return a value in mm for each sample; equal for samples at one place. The size of the
///         gradient is about 1.
std::vector<double> guide_field(const PartSamples& samples, const BallCutter& cutter,
                                double height, TravelKind distance);

}  // namespace endmill
