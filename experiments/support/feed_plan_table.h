// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/feed_plan.h"
#include "support/named_cells.h"

namespace endmill {

/// What a plan is compared with.
struct ConstantFeed {
    double noncut_min;  ///< what is not cutting takes, in either
    double feed_mm_per_min;
};

/// What a plan amounts to: cut_min, mean_feed_mm_per_min; beside the constant feed total_min,
/// saving_percent and cut_saving_percent (of the cutting time alone).
NamedCells time_cells(const FeedPlan& plan, const ConstantFeed& constant);

/// The shares of the length at each limit (force_share, thrust_share, torque_share, cap_share,
/// block_share, infeasible_share) and speed limit (economic_share, spindle_share, power_share,
/// drive_share), the infeasible moves, max_torque_n_m and max_power_w.
NamedCells limit_cells(const FeedPlan& plan);

/// What the paper says of its plans, "yes" where it holds of all of `plans`: mostly_force,
/// sometimes_thrust, never_torque_or_power.
NamedCells limit_claims(const std::vector<FeedPlan>& plans);

/// What a change of the model moves: total_min; force_share to infeasible_share and infeasible;
/// quantiles of R_m over the moves, peak_factor_5, _50, _95 and _greatest; of the moves that
/// the thrust limits, means thrust_depth_mm, thrust_lambda_deg and thrust_mu_deg.
NamedCells sensitivity_cells(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                             double noncut_min);

}  // namespace endmill
