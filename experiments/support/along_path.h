// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "endmill/process/feed_plan.h"
#include "support/experiment.h"
#include "support/named_cells.h"

namespace endmill {

/// Adds one row each for mu_deg, lambda_deg, pick_feed_mm, pick_feed_horizontal_mm and
/// depth_mm: least, mean (over the moves that have the value), greatest, and
/// largest_step_share, the largest change between neighbouring moves of a pass over the
/// whole range; and in_air_percent, the share of moves.
void add_geometry(CsvTable& table, const std::vector<SegmentCut>& cuts);

/// Adds one row each for feed and speed of `plan`: least, greatest, greatest_over_least
/// and mean over the length of the cuts. The labels begin with `name`.
void add_feeds(CsvTable& table, const std::string& name,
               const std::vector<SegmentCut>& cuts, const FeedPlan& plan);

/// Stretches of moves in which the feed per tooth is at its cap.
struct CapJumps {
    int count = 0;           ///< number of stretches, each within a pass
    int at_the_top = 0;      ///< number of those with a depth below `shallow_mm`
    double longest_mm = 0;   ///< length of the longest stretch
    int passes = 0;          ///< number of passes with a stretch
    int shallow_passes = 0;  ///< number of passes with a depth below `shallow_mm`
    int shallow_passes_with_jump = 0;  ///< number of those with a stretch at the top
    int above_cap = 0;                 ///< number of moves with a feed above the cap
};

/// \param shallow_mm depth below which the tip is about to leave the stock.
/// \param cap_mm largest feed per tooth.
CapJumps cap_jumps(const std::vector<SegmentCut>& cuts, const FeedPlan& plan,
                   double shallow_mm, double cap_mm);

/// The cells of `jumps`: jumps, at_the_top, longest_mm, passes_with_jump,
/// at_the_top_share (of the jumps), shallow_passes_share (of the passes that become
/// shallow: those with a jump at the top) and above_cap.
NamedCells jump_cells(const CapJumps& jumps);

/// Writes NAME.csv, one row for each move in the format of engagement.csv of the program,
/// and NAME.svg, the same over the length of the path. \param title of the picture.
void write_along(Experiment& run, const std::string& name, const std::string& title,
                 const std::vector<SegmentCut>& cuts, const FeedPlan& plan);

}  // namespace endmill
