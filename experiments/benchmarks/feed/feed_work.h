// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

// The work of `endmill feed`, whole and in parts: a ball of 5 mm with two flutes in the
// calibrated steel.

inline constexpr double feed_radius_mm = 5;  ///< of the ball

/// The options of all plans, with the rule `peak`.
FeedPlanOptions feed_options(PeakRule peak);

/// The engagements along `path`, with the stock as a block.
SegmentCuts cuts_along(const ToolPath& path);

/// The plan for `cuts`.
FeedPlan plan_feeds(const SegmentCuts& cuts, const FeedPlanOptions& options);

/// `path` with the feeds of `plan`.
ToolPath path_with_feeds(const ToolPath& path, const SegmentCuts& cuts,
                         const FeedPlan& plan);

/// Number of bytes of all texts that `feed` writes for the path with its feeds. They are
/// made in parallel, as by the command.
std::size_t written_bytes(const ToolPath& fed, const SegmentCuts& cuts,
                          const FeedPlan& plan);

/// The whole work of the command on the text of a path. \return number of bytes written.
std::size_t whole_feed(const std::string& text, int threads);

/// A program in G-code along `path`, at one feed.
std::string program_along(ToolPath path);

/// The work of the command on a long program, in blocks and pieces as by the command but
/// without its chart. \return number of bytes written.
std::size_t program_feed(const std::string& program, int threads);

/// A plan with the engagement of the simulated stock. \return the last feed, mm/min.
double stock_feed(const ToolPath& path, const SegmentCuts& cuts, PeakRule peak,
                  int threads);

}  // namespace endmill
