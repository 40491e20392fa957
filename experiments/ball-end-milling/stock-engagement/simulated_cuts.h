// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/detail/one_way_passes.h"
#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// Engagement of the ball in a simulated block.
struct SimulatedCuts {
    std::vector<BallFront> fronts;  ///< engaged region of each move
    double removed_mm3;             ///< volume that all moves remove
};

/// Cuts `milled` from a block with the extent and the top of `plan`; its bottom is at z = -30.
/// \param pitch of the stock's cells, mm.
SimulatedCuts simulated_cuts(const OneWayPasses& plan, const MilledPath& milled,
                             double pitch);

/// The feed plan for the simulated engagement.
FeedPlan simulated_plan(const std::vector<SegmentCut>& cuts,
                        const SimulatedCuts& simulated, const MillingJob& job,
                        const FeedPlanOptions& options);

/// Means of the coefficients I5 and I7 over the length of the path, and the volume that I7 implies:
/// mean_i5, mean_i7, removed_mm3.
NamedCells engagement_cells(const std::vector<SegmentCut>& cuts,
                            const std::vector<CuttingCoefficients>& coefficients,
                            double radius);

}  // namespace endmill
