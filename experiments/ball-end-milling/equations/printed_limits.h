// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// Cases for the printed equations of limits and speed.
struct LimitCases {
    double r1;  ///< radial over tangential force of the chip
    double r2;  ///< radial over tangential edge force
    double feed_per_tooth_mm;
    double life_min;  ///< T0
};

/// Adds:
/// - "eq. (15)": relative difference of the printed force from the magnitude of tangential
///   and radial force, for a material with `r1` and `r2`; "eq. (15), r2 = r1" for equal
///   ratios.
/// - "eq. (18)": relative difference of the printed spindle speed from the one that the
///   cutting speed of eq. (4) gives.
/// - "eq. (19)": the constant, kgf mm rpm/kW.
void add_limit_equations(CsvTable& result, const MillingJob& job,
                         const LimitCases& cases);

/// Adds:
/// - "limits on feed or speed alone": largest change in percent of the feed per tooth over
///   the path if the economic speed is halved.
/// - "less speed or less feed": used tool life at half the spindle speed over that at half
///   the feed per tooth, both at the same table feed.
void add_independence(CsvTable& result, const std::vector<SegmentCut>& cuts,
                      const MillingJob& job);

}  // namespace endmill
