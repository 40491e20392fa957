// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/detail/one_way_passes.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// The calibrated data set for "steel" or "aluminium": the file of the material, and the
/// tool and the machine that both share.
/// Source: docs/methods/ball-end-milling.md, section 8.
MillingJob reference_job(const std::string& material);

/// The same job with a right-hand cutter under M03. In down milling the frame of
/// BallEngagement is mirrored, so the helix angle of a right-hand cutter is negative
/// there.
/// Source: paper/notes/ball-engagement.md, section 5.
MillingJob right_hand_job(const MillingJob& job);

/// The path REF: the test surface of the formula, a ball of radius 5 mm, passes along x.
OneWayPasses reference_passes();

/// The moves of the path REF, with their lengths scaled to the printed total of 5385.6
/// mm.
std::vector<SegmentCut> reference_cuts();

/// Share of the length at a limit, from 0 to 1.
double limit_share(const FeedPlanTotals& totals, FeedLimit limit);
double limit_share(const FeedPlanTotals& totals, SpeedLimit limit);  ///< see above

}  // namespace endmill
