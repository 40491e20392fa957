// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/feed_input.h"
#include "endmill/process/fed_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// What was asked, read and planned.
struct FeedResult {
    const FeedInput& input;
    const FeedCommandOptions& options;
    const SegmentCuts& cuts;
    const FeedPlan& plan;
    ToolPath path;  ///< with feeds and speeds
    FeedTimes times;
    std::optional<double> planned_min;  ///< of the cuts, as the machine follows
    std::filesystem::path folder;       ///< to which it is written
    std::vector<std::string> remarks;   ///< of the path, and `feed_remarks`
};

/// summary.json of `feed`.
Json feed_summary(const FeedResult& result);

/// The same for a person.
std::string feed_text(const Json& summary);

/// Why no feed satisfies the limits on some moves, and which limits would do.
std::string infeasible_text(const Json& summary);

}  // namespace endmill
