// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/cutting_force.h"
#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// A move as it is milled.
struct MilledMove {
    SegmentCut cut;
    double feed_per_tooth_mm;
    double spindle_rpm;
};

/// What a force does while the cutter turns once.
struct TurnRange {
    CuttingForce least;
    CuttingForce greatest;
};

/// Of the forces of `job` on the work over a turn, in the frame of `mean_force`, at `steps`
/// equal azimuths; the paper's chip, no runout. Nothing in air: all 0.
TurnRange turn_range(const MilledMove& move, const MillingJob& job, int steps);

/// Forces at each of those azimuths.
std::vector<CuttingForce> turn_forces(const MilledMove& move, const MillingJob& job,
                                      int steps);

/// What a stroke amounts to: minutes, removed_mm3_per_min; the largest force either way along
/// x, y and z over all turns, force_x_n, force_y_n, thrust_n; and of the moves downhill alone,
/// downhill_x_n, downhill_y_n, downhill_thrust_n.
struct StrokeForces {
    double minutes = 0;
    double removed_mm3 = 0;
    CuttingForce largest{};
    CuttingForce largest_downhill{};
};

/// \param ranges one a move.
StrokeForces stroke_forces(const std::vector<MilledMove>& moves,
                           const std::vector<TurnRange>& ranges, const MillingJob& job);

/// minutes, removed_mm3_per_min, force_x_n, force_y_n, thrust_n, downhill_x_n, downhill_y_n,
/// downhill_thrust_n.
NamedCells stroke_cells(const StrokeForces& stroke);

}  // namespace endmill
