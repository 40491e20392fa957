// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/process/ball_engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/cutting_force.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// How a ball-end mill stands in the material on one straight cutting move: geometry at the
/// middle of the move. What is not known, or has no meaning for a first pass, is none.
/// Source: [ParkMaeng, eq. (8) to (14)]; spec of ball-end milling, sections 1, 3, 6.
struct SegmentCut {
    int pass = 0;                   ///< as in the path
    int point = 0;                  ///< as in the path: that to which the move leads
    double length_mm = 0;           ///< of the move of the ball's centre, above 0
    std::optional<double> mu = {};  ///< rise of the pick feed about the feed, rad
    double lambda = 0;              ///< rise of the feed, rad
    std::optional<double> pick_feed_mm = {};             ///< f_p, between the centres
    std::optional<double> pick_feed_horizontal_mm = {};  ///< f_p cos(mu)
    double depth_mm = 0;  ///< l, stock's top over the tip; 0 or less: in air
    PreviousPass previous = PreviousPass::Beside;  ///< needs mu and the pick feed
    Milling milling = Milling::Down;
    bool has_two_neighbours =
        false;  ///< an earlier pass on the other side too, further off
};

class CoefficientTable;

/// What cuts what, where.
struct MillingJob {
    CuttingMaterial material;
    MillingTool tool;
    MachineLimits machine = {};
};

/// How the largest load of a turn is found. Torque and Direct need the tool's helix.
/// Source: spec of ball-end milling, section 4; the paper uses a factor R_m that it does not
/// print.
enum class PeakRule {
    Constant,  ///< a given factor times the mean, for every load
    Torque,  ///< likewise, the factor being that of the chip's torque of the helical flutes
    Direct  ///< each load of the helical flutes as it runs, no factor
};

/// Choices of a feed plan. The defaults are those of mode `paper`.
struct FeedPlanOptions {
    ChipModel chip = ChipModel::Paper;
    PeakRule peak = PeakRule::Constant;
    double peak_factor = 1.8;           ///< R_m of PeakRule::Constant, from 1
    LimitForm form = LimitForm::Paper;  ///< of force and power
    std::optional<double> max_feed_per_tooth_mm = {};  ///< none: the material's, if any
    std::optional<double> min_feed_per_tooth_mm = {};  ///< none: the material's, or 0.005
    double block_time_ms = 10;  ///< least time of a block; 0: no such rule
    double accuracy = 1e-6;     ///< largest error of a cutting action coefficient
    /// Where PeakRule::Constant has its coefficients from; none: each is computed. Of the same
    /// chip, and outlives the plan.
    const CoefficientTable* table = nullptr;
};

/// The options of mode `corrected`: exact chip, direct peaks, exact limits.
FeedPlanOptions corrected_feed_options();

/// The feeds per tooth that may be used, as `options` or else the material say.
FeedRange feed_range(const CuttingMaterial& material, const FeedPlanOptions& options);

/// The rules that `job` and `options` make. The torque's limit is the smaller of the tool's
/// and the spindle's.
/// \throws DomainError unless all is sound, the peak factor is from 1, and the least feed per
///         tooth is at most the largest.
FeedRules feed_rules(const MillingJob& job, const FeedPlanOptions& options);

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
