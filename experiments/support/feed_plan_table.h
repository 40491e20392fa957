// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// The constant feed that a plan is compared with.
struct ConstantFeed {
    double noncut_min;  ///< non-cutting time, equal for both
    double feed_mm_per_min;
};

/// Times of a plan: cut_min, mean_feed_mm_per_min; total_min, saving_percent and
/// cut_saving_percent (of the cutting time alone) against the constant feed.
NamedCells time_cells(const FeedPlan& plan, const ConstantFeed& constant);

/// Shares of the length at each limit (force_share, thrust_share, torque_share,
/// cap_share, block_share, infeasible_share) and speed limit (economic_share,
/// spindle_share, power_share, drive_share), the number of infeasible moves,
/// max_torque_n_m and max_power_w.
NamedCells limit_cells(const FeedPlan& plan);

/// The paper's statements on its plans, "yes" if they hold for all of `plans`:
/// mostly_force, sometimes_thrust, never_torque_or_power.
NamedCells limit_claims(const std::vector<FeedPlan>& plans);

/// Quantities that a change of the model affects: total_min; force_share to
/// infeasible_share and infeasible; quantiles of R_m over the moves, peak_factor_5, _50,
/// _95 and _greatest; means over the moves that the thrust limits, thrust_depth_mm,
/// thrust_lambda_deg and thrust_mu_deg; thrust_deep_downhill, whether these means are
/// deeper than the mean of all moves and both negative; thrust_all_three_percent, the
/// share of the thrust-limited length with all three.
NamedCells sensitivity_cells(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                             double noncut_min);

}  // namespace endmill
