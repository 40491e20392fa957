// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/feed_input.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// The cuts of the path, with the engagement that --engagement selects.
/// \throws GeometryError if the path has no cuts or no cut meets the stock; also throws
///         as `segment_cuts`.
SegmentCuts feed_cuts(const FeedInput& input, const FeedCommandOptions& options);

/// Feeds of the cuts.
struct CutsPlan {
    FeedPlan feeds;
    std::vector<Milling> milling;  ///< up or down milling of each cut
};

/// Plans the feeds, either from the geometry of the cuts or from the simulated stock.
/// \throws GeometryError if no cut finds material in the stock; LimitError if the stock
///         needs more memory than the limit; also throws as `feed_plan`.
CutsPlan cuts_plan(const FeedInput& input, const SegmentCuts& cuts,
                   const FeedCommandOptions& options);

}  // namespace endmill
