// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/feed_options.h"
#include "endmill/process/segment_cut.h"
#include "endmill/process/segment_feed.h"

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

}  // namespace endmill
