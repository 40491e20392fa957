// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/feed_limits.h"
#include "endmill/process/milling_data.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// Lower bound of the engaged angle in the tool-life equation, in rad (5 degrees). A
/// smaller engagement does not wear the edge noticeably, and its economic speed would
/// have no bound.
inline constexpr double least_life_angle = std::numbers::pi / 36;

/// The engagement of a ball of `radius` mm on the move.
/// \throws DomainError unless the geometry is sound, or if mu or the pick feed is missing
///         although a previous pass lies beside the move.
BallEngagement ball_engagement(const SegmentCut& cut, double radius);

/// Engaged angle for the tool-life equation, in rad: the engaged angle, clamped to 5 to
/// 180 degrees. On a first pass it is 90 degrees at an edge and 180 degrees in a slot; in
/// air it is 5 degrees.
/// Source: docs/methods/ball-end-milling.md, sections 5 and 6; the choice is ours.
double tool_life_angle(const BallEngagement& engagement);

/// The same for an engagement whose `engaged_angle` is known, in rad.
double tool_life_angle(const BallEngagement& engagement, double engaged_angle);

/// I5 to I8 of all flutes, times `factor`.
EdgeSums edge_sums(const CuttingCoefficients& coefficients, int flutes, double factor);

/// Load of the move if every load is `factor` times its mean (PeakRule::Constant).
/// \param cut the move.
/// \param engaged coefficients and engaged angle of the move.
/// \param factor R_m.
/// \param rules must outlive the result.
/// \pre Rules and cut are sound.
SegmentLoad constant_peak_load(const SegmentCut& cut, const EngagedCoefficients& engaged,
                               double factor, const FeedRules& rules);

/// Load of the move if every load is its mean times the peak factor of the chip's torque
/// of the helical flutes (PeakRule::Torque). The load of a move in air is 0.
/// \param cut the move.
/// \param tool the cutter of the rules.
/// \param chip definition of the chip thickness.
/// \param rules must outlive the result.
/// \throws GeometryError if the flutes wind more than 1000 times about the axis within
///         the cut; the message names the move.
/// \pre Rules and cut are sound.
SegmentLoad torque_peak_load(const SegmentCut& cut, const MillingTool& tool,
                             ChipModel chip, const FeedRules& rules);

/// Load of the move if each load is computed over a revolution of the helical flutes
/// (PeakRule::Direct). The load of a move in air is 0. Parameters, errors and
/// preconditions are those of `torque_peak_load`.
SegmentLoad direct_peak_load(const SegmentCut& cut, const MillingTool& tool,
                             ChipModel chip, const FeedRules& rules);

}  // namespace endmill
