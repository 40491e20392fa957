// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/feed_cuts.h"

namespace endmill {

/// Remarks on a feed plan, in addition to those of the path. They count cutting moves of
/// zero length, moves between two earlier passes, and moves on which the model's sense of
/// the helix differs from a right-hand cutter under M03 (MillingTool::helix).
std::vector<std::string> feed_remarks(const FeedInput& input, const FedCuts& cuts);

}  // namespace endmill
