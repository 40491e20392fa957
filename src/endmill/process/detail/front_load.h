// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// Checks a front.
/// \throws DomainError unless `front` has as many cells as it states, its slope is within
///         a right angle, and its shank heights are finite and not negative.
void require_sound(const BallFront& front);

/// Cutting action coefficients of a front, in its frame, by the midpoint rule over its
/// cells and over the azimuths of its shank.
/// Source: docs/methods/ball-end-milling.md, sections 2, 3.4 and 12.
/// \throws DomainError unless `front` is sound.
/// Error below 3e-3 for 96 by 128 cells whose middles are classified correctly.
CuttingCoefficients front_coefficients(const BallFront& front, ChipModel chip);

/// The sums over all edges of a helical mill with a measured front during a spindle
/// revolution. Sums and sense of the helix are those of ForcePattern; the midpoint rule
/// along each edge evaluates them. Accurate to about the width of a cell: 1 to 3 % of the
/// largest sum.
/// Source: docs/methods/ball-end-milling.md, sections 4 and 12.
class FrontPattern {
public:
    /// \throws DomainError unless `front` and `tool` are sound.
    FrontPattern(const BallFront& front, ChipModel chip, const MillingTool& tool);

    /// Peak factor R_m: largest torque of the chip over its mean; 1 if nothing is cut.
    double peak_factor() const;

    /// Means of the sums over a revolution.
    EdgeSums mean() const;

    /// Largest feeds per tooth in mm at which no limit is exceeded at any time of the
    /// revolution.
    FeedBounds direct_bounds(const LoadModel& model, const LoadLimits& limits) const;

    /// Largest value of each load in a revolution at a feed per tooth.
    CuttingLoads largest_loads(const LoadModel& model, double feed_per_tooth_mm) const;

private:
    std::vector<EdgeSums> sums_;  // at equal steps of the flutes' period
};

}  // namespace endmill
