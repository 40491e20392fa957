// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/detail/one_way_passes.h"
#include "endmill/process/detail/stroke_forces.h"

namespace endmill {

/// What the ball meets in a simulated block.
struct SimulatedCuts {
    std::vector<BallFront> fronts;  ///< one a move
    double removed_mm3;             ///< by all moves
};

/// Cuts `milled` from a block of the plan's extent, from `bottom` to its stock's top.
/// \param pitch of the stock's cells, mm.
SimulatedCuts simulated_cuts(const OneWayPasses& plan, const MilledPath& milled,
                             double pitch);

/// The plan by the engagement of the fronts.
FeedPlan simulated_plan(const std::vector<SegmentCut>& cuts,
                        const SimulatedCuts& simulated, const MillingJob& job,
                        const FeedPlanOptions& options);

/// Cutting forces in N, the largest in a turn of the helical flutes at each move, the paper's
/// chip: by the model's engagement, and by that of the fronts.
std::vector<double> idealised_peaks(const std::vector<MilledMove>& moves,
                                    const MillingJob& job);
std::vector<double> simulated_peaks(const std::vector<MilledMove>& moves,
                                    const SimulatedCuts& simulated,
                                    const MillingJob& job);  ///< see above

/// Coefficients over the path, weighted by length, and the volume that they say is removed:
/// mean_i5, mean_i7, removed_mm3.
NamedCells engagement_cells(const std::vector<SegmentCut>& cuts,
                            const std::vector<CuttingCoefficients>& coefficients,
                            double radius);

}  // namespace endmill
