// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/feed_plan.h"
#include "support/experiment.h"
#include "support/named_cells.h"

namespace endmill {

/// Adds a row each for mu_deg, lambda_deg, pick_feed_mm, pick_feed_horizontal_mm and depth_mm:
/// least, mean (of the moves where it is told) and greatest; and in_air_percent of the moves.
void add_geometry(CsvTable& table, const std::vector<SegmentCut>& cuts);

/// Adds a row each for the feed and the speed of `plan`, their least, greatest and mean over
/// the length of the cuts; rows begin with `name`.
void add_feeds(CsvTable& table, const std::string& name,
               const std::vector<SegmentCut>& cuts, const FeedPlan& plan);

/// How often the feed per tooth rises to its cap.
struct CapJumps {
    int count = 0;          ///< stretches of moves at the cap, each within a pass
    int at_the_top = 0;     ///< of these, where l is below `shallow_mm` somewhere
    double longest_mm = 0;  ///< stretch
};

/// \param shallow_mm depth below which the tip is about to leave the stock.
CapJumps cap_jumps(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                   double shallow_mm);

/// Writes NAME.csv, a row a move (as the file engagement.csv of the program), and NAME.svg, the
/// same over the length of the path.
/// \param title above the picture.
void write_along(Experiment& run, const std::string& name, const std::string& title,
                 const std::vector<SegmentCut>& cuts, const FeedPlan& plan);

}  // namespace endmill
