// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "ball-end-milling/stock-engagement/simulated_cuts.h"

namespace endmill {

/// Adds `engagement_cells` of both engagements with the exact chip, and the volume that
/// the simulated stock lost: rows "idealised", "simulated", "stock"; and the quotients of
/// the first two.
void add_engagements(CsvTable& table, const std::vector<SegmentCut>& cuts,
                     const SimulatedCuts& simulated, double radius);

/// Feed plans of one path, judged by the true force peaks with either engagement.
struct PeakForceRun {
    const std::vector<SegmentCut>& cuts;
    const SimulatedCuts& simulated;
    MillingJob job;

    /// An empty table of peaks along the path: row, pass, travel_mm (in the pass), plan,
    /// idealised_n, simulated_n, right_hand_idealised_n, right_hand_simulated_n.
    static CsvTable along_table();

    /// Adds a row to `table`: cut_min, infeasible, and for both engagements the largest
    /// peak and the share of the length whose peak exceeds the tool's limit by more than
    /// 2 %, the accuracy of the cells of the front; the same for a right-hand cutter
    /// under M03 (`right_hand_job`). Adds the peaks of each move to `along`.
    void add(CsvTable& table, CsvTable& along, const std::string& name,
             const FeedPlan& plan) const;
};

}  // namespace endmill
