// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/detail/one_way_passes.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// The calibrated set of datasets/ for a material, "steel" or "aluminium": the file of the
/// material, the tool that both share, the machine as set for the material.
/// Source: docs/mathematics/ball-end-milling.md, section 8, REF set.
MillingJob reference_job(const std::string& material);

/// The same with the helix of a right-hand cutter under M03 that mills down: in the frame of
/// BallEngagement, which is mirrored then, its edges trail the other way.
/// Source: paper/notes/ball-engagement.md, section 5.
MillingJob right_hand_job(const MillingJob& job);

/// The path REF: the formula's test surface, a ball of 5 mm, passes along x.
OneWayPasses reference_passes();

/// Its moves, their lengths stretched to the 5385.6 mm that the paper prints.
std::vector<SegmentCut> reference_cuts();

/// The share of the length at a limit, 0 … 1.
double limit_share(const FeedPlanTotals& totals, FeedLimit limit);
double limit_share(const FeedPlanTotals& totals, SpeedLimit limit);  ///< see above

}  // namespace endmill
