// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cli/feed_cuts.h"
#include "cli/feed_input.h"
#include "endmill/process/fed_path.h"

namespace endmill {

/// Options, input and result of a feed plan.
struct FeedResult {
    const FeedInput& input;
    const FeedCommandOptions& options;
    const FedCuts& cuts;
    FeedTimes times;
    std::optional<double>
        planned_min;               ///< time of the cuts with the machine's acceleration
    std::filesystem::path folder;  ///< folder of the results
    std::vector<std::string> remarks;  ///< of the path, and `feed_remarks`
};

/// summary.json of `feed`.
Json feed_summary(const FeedResult& result);

/// The report on the terminal.
std::string feed_text(const Json& summary);

/// The message for moves on which no feed satisfies the limits, with sufficient limits.
std::string infeasible_text(const Json& summary);

}  // namespace endmill
