// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/process/detail/one_way_passes.h"
#include "endmill/process/feed_plan.h"
#include "support/experiment.h"

namespace endmill {

/// Writes the files of which `endmill view` makes a page: toolpath.csv; summary.json with the
/// cutter and the part; with feeds also engagement.csv. The path returns 5 mm above the stock.
/// \param part  file of the part, from the folder of the results or from the working directory.
/// \param feeds of all moves of `milled`; may be null.
void write_passes_for_view(Experiment& run, const OneWayPasses& plan,
                           const MilledPath& milled, const std::string& part,
                           const FeedPlan* feeds = nullptr);

/// The moves of one pass.
MilledPath moves_of_pass(const MilledPath& milled, int pass);

}  // namespace endmill
