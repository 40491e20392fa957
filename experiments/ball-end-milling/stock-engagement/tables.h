// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ball-end-milling/stock-engagement/simulated_cuts.h"

namespace endmill {

/// Adds `engagement_cells` of the idealised and the simulated engagement, with the exact chip,
/// and what the simulated stock lost: rows "idealised", "simulated", "stock".
void add_engagements(CsvTable& table, const std::vector<SegmentCut>& cuts,
                     const SimulatedCuts& simulated, double radius);

/// Plans of one path judged by the true peaks of the force, in either engagement.
struct PeakForceRun {
    const std::vector<SegmentCut>& cuts;
    const SimulatedCuts& simulated;
    MillingJob job;

    /// A table for what goes on along the path: row, pass, travel_mm (in the pass), plan,
    /// idealised_n, simulated_n, right_hand_idealised_n, right_hand_simulated_n.
    static CsvTable along_table();

    /// Adds to `table` what `plan` amounts to: cut_min, infeasible, and for both engagements
    /// the largest peak and the share of the length whose peak is over the tool's limit by more
    /// than 2 % (what cells of the front are good for); the same of a right-hand cutter under
    /// M03 (`right_hand_job`); and to `along` the peaks of each move.
    void add(CsvTable& table, CsvTable& along, const std::string& name,
             const FeedPlan& plan) const;
};

}  // namespace endmill
