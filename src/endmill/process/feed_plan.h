// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Feed and spindle speed for every cutting move of a path. Start here: `feed_plan` is
/// the main function of the module.

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/milling_data.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// The material, the tool and the machine of a feed plan.
struct MillingJob {
    CuttingMaterial material;    ///< force constants and speeds
    MillingTool tool;            ///< geometry and limits
    MachineLimits machine = {};  ///< limits of spindle and feed drives
};

/// The rule for the peak load, the largest load in a spindle revolution. Torque and
/// Direct need the helix of the tool.
/// Source: docs/methods/ball-end-milling.md, section 4. The paper uses a factor R_m
/// that it does not print.
enum class PeakRule {
    Constant,  ///< every load is a given factor times its mean
    /// R_m = largest / mean chip torque of the helical flutes; it multiplies the mean of
    /// every load.
    Torque,
    Direct  ///< each load is computed over the revolution; no factor
};

/// Choices of a feed plan. The defaults are those of the mode `paper`.
struct FeedPlanOptions {
    ChipModel chip = ChipModel::Paper;   ///< definition of the chip thickness
    PeakRule peak = PeakRule::Constant;  ///< how the largest load is found
    double peak_factor = 1.8;            ///< R_m of PeakRule::Constant, at least 1
    LimitForm form = LimitForm::Paper;   ///< form of the limits of force and power
    /// Largest feed per tooth in mm. By default that of the material, if it has one.
    std::optional<double> max_feed_per_tooth_mm = {};
    /// Least feed per tooth in mm. By default that of the material, if it has one, else
    /// 0.005.
    std::optional<double> min_feed_per_tooth_mm = {};
    double block_time_ms = 10;  ///< ms, least time of a block; 0 switches the rule off
    double accuracy = 1e-6;     ///< bound of the error of a cutting action coefficient
    /// Table from which PeakRule::Constant takes its coefficients; null: each is
    /// computed. The table must be of the same chip model and outlive the plan.
    const CoefficientTable* table = nullptr;
};

/// The options of the mode `corrected`: exact chip, direct peaks, exact limits.
FeedPlanOptions corrected_feed_options();

/// The range of the feed per tooth: that of `options`, or else that of the material.
FeedRange feed_range(const CuttingMaterial& material, const FeedPlanOptions& options);

/// The rules that `job` and `options` imply. The limit of the torque is the smaller of
/// the tool's and the spindle's.
/// \throws DomainError unless all data are sound, the peak factor is at least 1, and the
///         least feed per tooth is at most the largest.
FeedRules feed_rules(const MillingJob& job, const FeedPlanOptions& options);

/// Load of a move of `length_mm` whose engagement was measured in the stock.
/// \param length_mm mm, length of the move, above 0.
/// \param front engaged cells of the ball's front and heights of the shank.
/// \param tool the cutter.
/// \param options chip model and peak rule.
/// \param rules from `feed_rules` for the same tool; they must outlive the result.
/// \throws DomainError unless `front` is sound: it has as many cells as it states, its
///         slope is within a right angle, and its heights are finite and not negative.
/// \pre `rules` and `tool` are sound.
/// Source: docs/methods/ball-end-milling.md, section 12.
SegmentLoad front_load(double length_mm, const BallFront& front, const MillingTool& tool,
                       const FeedPlanOptions& options, const FeedRules& rules);

/// Totals of a feed plan. Shares are fractions of the total length.
struct FeedPlanTotals {
    double length_mm = 0;  ///< mm, length of all cutting moves
    double cut_min = 0;    ///< min, time of all cutting moves at their feeds
    /// Share of the length for which each limit governs the feed, in the order of
    /// `all_feed_limits`.
    std::array<double, all_feed_limits.size()> limit_shares{};
    /// Share of the length for which each limit governs the spindle speed, in the order
    /// of `all_speed_limits`.
    std::array<double, all_speed_limits.size()> speed_limit_shares{};
    std::size_t infeasible = 0;  ///< number of infeasible moves
    /// The smallest limits for which every move would be feasible at the least feed per
    /// tooth. A limit that makes no move infeasible is missing.
    LoadLimits needed = {};
    double max_torque_n_m = 0;  ///< N m, largest torque of all moves
    double max_power_w = 0;     ///< W, largest power of all moves
};

/// Feed and spindle speed of every cutting move of a path.
struct FeedPlan {
    std::vector<SegmentFeed> rows;  ///< one per move, in order
    FeedPlanTotals totals;          ///< sums over the rows
};

/// Feed and spindle speed of `count` moves. Moves are planned independently, on all
/// threads.
/// \param count number of moves.
/// \param load_of returns the load of move i; called once per move, from any thread.
/// \param rules limits of tool, spindle and drives.
/// \throws DomainError as `segment_feed`, or if the rules are not sound.
/// The plan does not depend on the number of threads.
FeedPlan feed_plan(std::size_t count,
                   const std::function<SegmentLoad(std::size_t)>& load_of,
                   const FeedRules& rules);

/// Feed and spindle speed of each of `cuts`. For each cut the function computes the
/// engagement, then the cutting coefficients or the loads over a spindle revolution, then
/// the stages I to IV of `segment_feed`.
/// Source: [ParkMaeng, section 4]; docs/methods/ball-end-milling.md, sections 4 to 6.
/// \throws DomainError unless `cuts`, `job` and `options` are sound, or if nothing bounds
///          a feed.
/// \throws GeometryError if the flutes wind more than 1000 times about the axis within a
///         cut; the message names the move.
FeedPlan feed_plan(std::span<const SegmentCut> cuts, const MillingJob& job,
                   const FeedPlanOptions& options);

/// A function that takes the number of a move and the engaged front of the ball on it.
using FrontVisit = std::function<void(std::size_t number, const BallFront& front)>;

/// Feeds of moves whose engagement was measured in the stock.
struct MeasuredFeeds {
    FeedPlan plan;                 ///< feed and spindle speed of each move
    std::vector<Milling> milling;  ///< side of the feed with the stock, for each move
    bool has_engagement = false;   ///< whether some move finds material
};

/// Feed and spindle speed of each of `cuts` from the engagement that `measure` finds in
/// the stock, instead of that of the geometry. The plan does not depend on the order of
/// the visits.
/// \param cuts only their lengths are used.
/// \param job material, tool and machine.
/// \param options chip model and peak rule.
/// \param measure calls its argument once for each of `cuts`, from any thread, as
///        `for_each_ball_front` of the module stock does.
/// \throws DomainError as `feed_rules`, `front_load` and `segment_feed`.
/// Source: docs/methods/ball-end-milling.md, section 12.
MeasuredFeeds measured_feed_plan(
    std::span<const SegmentCut> cuts, const MillingJob& job,
    const FeedPlanOptions& options,
    const std::function<void(const FrontVisit& visit)>& measure);

/// Adds up the totals of a plan row by row, in the order of the moves.
class FeedTotalsSum {
public:
    /// \param limits the limits of the plan, from FeedRules.
    explicit FeedTotalsSum(const LoadLimits& limits) : limits_{limits} {}

    /// Adds the row of a move of `length_mm`.
    void add(const SegmentFeed& row, double length_mm);

    /// The totals so far.
    FeedPlanTotals totals() const;

private:
    LoadLimits limits_;
    FeedPlanTotals sum_;  // its shares are lengths
};

/// Totals of a plan, summed over its rows in the order of the moves.
/// \param rows the rows of the plan.
/// \param lengths_mm mm, one length per row.
/// \param limits the limits of the plan, from FeedRules.
/// \throws DomainError unless there is one length per row.
/// Source: [ParkMaeng, section 5]; docs/methods/ball-end-milling.md, sections 6, 8
/// and 13.
FeedPlanTotals feed_plan_totals(const std::vector<SegmentFeed>& rows,
                                const std::vector<double>& lengths_mm,
                                const LoadLimits& limits);

}  // namespace endmill
