// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "cli/feed_input.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// The cuts of the path, as --engagement says.
/// \throws GeometryError if there are none, or none meets the stock; as `segment_cuts`.
SegmentCuts feed_cuts(const FeedInput& input, const FeedCommandOptions& options);

/// The feeds of cuts.
struct CutsPlan {
    FeedPlan feeds;
    std::vector<Milling> milling;  ///< one a cut: where the stock is
};

/// Their feeds: from their geometry, or from the stock that they find.
/// \throws GeometryError if none finds material in the stock; LimitError if the stock needs more memory than the limit; as `feed_plan`.
CutsPlan cuts_plan(const FeedInput& input, const SegmentCuts& cuts,
                   const FeedCommandOptions& options);

}  // namespace endmill
