// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include "endmill/cutter/engagement.h"
#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// Thinner engagements cut nothing that wears the edge, and their economic speed has no bound.
inline constexpr double least_life_angle = std::numbers::pi / 36;  ///< 5 degrees, rad

/// The engagement of a ball of `radius` mm on the move.
/// \throws DomainError unless the geometry is sound, and mu and the pick feed are told if a
///         previous pass is there.
BallEngagement ball_engagement(const SegmentCut& cut, double radius);

/// The angle over which an edge cuts in a turn, for the tool's life, in rad: the engaged angle,
/// no less than 5 and no more than 180 degrees; 90 of a first pass on an edge, 180 in a slot,
/// 5 in air. Source: spec of ball-end milling, sections 5 and 6; our choice.
double tool_life_angle(const BallEngagement& engagement);

/// I5 to I8 of all flutes, times `factor`.
EdgeSums edge_sums(const CuttingCoefficients& coefficients, int flutes, double factor);

/// What the move asks for if each load is `factor` times its mean.
/// \param coefficients of the engagement. \pre Rules and cut are sound; the rules outlive what
///        is returned.
SegmentLoad factored_load(const SegmentCut& cut, const CuttingCoefficients& coefficients,
                          double factor, const FeedRules& rules);

/// What the move asks for if the loads are those of the helical flutes as they turn: with one
/// factor, R_m, by PeakRule::Torque; load by load, without a factor, by PeakRule::Direct. In
/// air nothing is asked for.
/// \throws GeometryError naming the move if the flutes wind more than `most_windings` times
///         about the axis in the cut.
/// \param rule Torque or Direct. \pre As `factored_load`; the tool is that of the rules.
SegmentLoad turning_load(const SegmentCut& cut, const MillingTool& tool, PeakRule rule,
                         ChipModel chip, const FeedRules& rules);

/// \throws DomainError unless `front` has as many cells and azimuths as it says, its slope is
///         within a right angle and no height is negative or not finite.
void require_sound(const BallFront& front);

/// The coefficients of what `front` says is engaged, in its frame: by the midpoint rule over
/// its cells, and over the azimuths of the shank.
/// Source: spec of ball-end milling, sections 2, 3.4 and 12.
/// \throws DomainError unless `front` is sound.
/// Error below 3e-3 of 96 by 128 cells that are as exact as their middles.
CuttingCoefficients front_coefficients(const BallFront& front, ChipModel chip);

/// What all edges bear while a helical mill turns in what `front` says is engaged: the sums
/// of ForcePattern, its sense of the helix included, by the midpoint rule along each edge, cell by cell. To about a cell's
/// width, 1 to 3 % of the largest.
/// Source: spec of ball-end milling, section 4.
class FrontPattern {
public:
    /// \throws DomainError unless `front` and `tool` are sound.
    FrontPattern(const BallFront& front, ChipModel chip, const MillingTool& tool);

    /// R_m: the largest torque of the chip over its mean; 1 where nothing is cut.
    double peak_factor() const;
    EdgeSums mean() const;  ///< over a turn

    /// The largest feeds per tooth in mm at which no limit is passed at any time.
    FeedBounds direct_bounds(const LoadModel& model, const LoadLimits& limits) const;

    /// The largest of each load over a turn at a feed per tooth.
    CuttingLoads largest_loads(const LoadModel& model, double feed_per_tooth_mm) const;

private:
    std::vector<EdgeSums> sums_;  // at equal steps of the flutes' period
};

/// What a move of `length_mm` asks for whose engagement is `front`.
/// \pre Rules and tool are sound, and of each other; the rules outlive what is returned.
/// \throws DomainError unless `front` is sound.
SegmentLoad front_load(double length_mm, const BallFront& front, const MillingTool& tool,
                       const FeedPlanOptions& options, const FeedRules& rules);

}  // namespace endmill
