// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/feed_plan.h"
#include "endmill/process/detail/stroke_forces.h"

namespace endmill {

/// The moves at one feed of the table and one speed of the spindle.
std::vector<MilledMove> constant_moves(const std::vector<SegmentCut>& cuts, int flutes,
                                       double feed_mm_per_min, double spindle_rpm);

/// The share of a tool's life that the moves use up: the sum of dt / T with
/// V (phi/pi T)^alpha = C_b, V the speed of the ball's widest circle, and C_b = V1 T0^alpha for
/// a life of `life_min`.
/// Source: [ParkMaeng, eq. (4)]; spec of ball-end milling, sections 5 and 14.
double used_life(const std::vector<MilledMove>& moves, const MillingJob& job,
                 double life_min);

/// The largest cutting force that the helical flutes bear in any turn, with the paper's chip.
struct PeakForces {
    double shallow_n;  ///< on moves that are cut less deep than asked for
    double all_n;      ///< on all moves
};

/// \param depth_mm of what is called shallow.
PeakForces peak_forces(const std::vector<MilledMove>& moves, const MillingJob& job,
                       double depth_mm);

}  // namespace endmill
