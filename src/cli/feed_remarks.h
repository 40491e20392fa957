// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/feed_cuts.h"

namespace endmill {

/// What a person has to know of a plan beside its numbers and the path's own remarks: cutting
/// moves that go nowhere, moves between two earlier passes, and those on which the
/// model's sense of the helix is not that of a right-hand cutter under M03 (MillingTool::helix).
std::vector<std::string> feed_remarks(const FeedInput& input, const SegmentCuts& cuts,
                                      const CutsPlan& plan);

}  // namespace endmill
