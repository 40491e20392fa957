// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/process/feed_options.h"
#include "endmill/process/segment_cut.h"
#include "endmill/process/segment_feed.h"

namespace endmill {

/// The least limits with which every move were feasible at the least feed per tooth; none
/// where a limit makes no move infeasible.
struct NeededLimits {
    std::optional<double> cutting_force_n = {};
    std::optional<double> thrust_n = {};
    std::optional<double> torque_n_m = {};
};

/// What a feed plan amounts to. Shares are of the length of all moves.
struct FeedPlanTotals {
    double length_mm = 0;
    double cut_min = 0;
    std::array<double, all_feed_limits.size()> limit_shares{};  ///< as all_feed_limits
    std::array<double, all_speed_limits.size()>
        speed_limit_shares{};    ///< all_speed_limits
    std::size_t infeasible = 0;  ///< moves
    NeededLimits needed = {};
    double max_torque_n_m = 0;
    double max_power_w = 0;
};

/// Feed and spindle speed of every cutting move of a path.
struct FeedPlan {
    std::vector<SegmentFeed> rows;  ///< in the order of the moves
    FeedPlanTotals totals;
};

/// Feed and speed of each of `count` moves, move by move.
/// \param load_of what move i asks for; called once a move, from any thread.
/// \throws DomainError as `segment_feed`, or unless the rules are sound.
/// The plan is the same with any number of threads.
FeedPlan feed_plan(std::size_t count,
                   const std::function<SegmentLoad(std::size_t)>& load_of,
                   const FeedRules& rules);

/// Feed and speed of each of `cuts`: engagement, coefficients or the run of the loads, stages
/// I to IV.
/// Source: [ParkMaeng, section 4]; spec of ball-end milling, sections 4 to 6.
/// \throws DomainError unless `cuts`, job and options are sound; if nothing bounds a feed.
FeedPlan feed_plan(std::span<const SegmentCut> cuts, const MillingJob& job,
                   const FeedPlanOptions& options);

/// What the rows amount to; the totals are sums in the order of the moves.
/// \param lengths_mm one a row. \throws DomainError for another number of them.
/// Source: [ParkMaeng, section 5]; spec of ball-end milling, sections 6, 8, 13.
FeedPlanTotals feed_plan_totals(const std::vector<SegmentFeed>& rows,
                                const std::vector<double>& lengths_mm,
                                const LoadLimits& limits);

}  // namespace endmill
