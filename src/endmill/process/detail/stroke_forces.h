// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// A cutting move with its feed per tooth and spindle speed.
struct MilledMove {
    SegmentCut cut;
    double feed_per_tooth_mm;
    double spindle_rpm;
};

/// The moves with the spindle speed of `plan`, and with its feed per tooth or, if given,
/// one constant feed per tooth in mm. \pre one row of the plan for each cut.
std::vector<MilledMove> milled_moves(const std::vector<SegmentCut>& cuts,
                                     const FeedPlan& plan,
                                     const std::optional<double>& feed_per_tooth_mm);

/// The moves with one table feed and one spindle speed.
std::vector<MilledMove> constant_moves(const std::vector<SegmentCut>& cuts, int flutes,
                                       double feed_mm_per_min, double spindle_rpm);

/// Forces on the work at `steps` equal azimuths of one spindle revolution, in the frame
/// of `mean_force`, with the paper's chip and without runout. All are 0 for a move in
/// air.
std::vector<CuttingForce> turn_forces(const MilledMove& move, const MillingJob& job,
                                      int steps);

/// Range of each force component in one spindle revolution.
struct ForceRange {
    CuttingForce least;
    CuttingForce greatest;
};

/// Range of `turn_forces`.
ForceRange turn_range(const MilledMove& move, const MillingJob& job, int steps);

/// Totals of a stroke. A largest force is the largest magnitude in either sense.
struct StrokeForces {
    double minutes = 0;
    double removed_mm3 = 0;
    CuttingForce largest{};           ///< over all moves
    CuttingForce largest_downhill{};  ///< over the moves with a falling feed, lambda < 0
};

/// Sums time and volume, and takes the largest forces over all moves.
/// \param ranges `turn_range` of each move.
StrokeForces stroke_forces(const std::vector<MilledMove>& moves,
                           const std::vector<ForceRange>& ranges, const MillingJob& job);

/// Share of the tool life that the moves use: the sum of dt / T with V (phi/pi T)^alpha =
/// C_b. V is the speed of the largest circle of the ball, and C_b = V1 T0^alpha for T0 =
/// `life_min`.
/// Source: [ParkMaeng, eq. (4)]; docs/methods/ball-end-milling.md, sections 5 and 14.
double used_life(const std::vector<MilledMove>& moves, const MillingJob& job,
                 double life_min);

/// Largest value of each load of the helical flutes in a spindle revolution of each move,
/// with the paper's chip and the engagement of the model; 0 for a move in air. Uses all
/// threads.
std::vector<CuttingLoads> peak_loads(const std::vector<MilledMove>& moves,
                                     const MillingJob& job);

/// The cutting forces of `peak_loads`, N.
std::vector<double> peak_cutting_forces(const std::vector<MilledMove>& moves,
                                        const MillingJob& job);

/// The same with measured engagements. \param fronts the engaged region of each move.
std::vector<double> peak_cutting_forces(const std::vector<MilledMove>& moves,
                                        const std::vector<BallFront>& fronts,
                                        const MillingJob& job);

}  // namespace endmill
