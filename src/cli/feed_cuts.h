// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "cli/feed_input.h"
#include "endmill/process/fed_path.h"
#include "endmill/process/feed_plan.h"
#include "endmill/process/segment_cuts.h"

namespace endmill {

/// The finder of the cuts of `path`, with the engagement that --engagement selects.
/// \param path must outlive the finder.
/// \throws GeometryError if the path has no cuts or no cut meets the stock; also throws
///         as `segment_cuts`.
std::unique_ptr<const SegmentCutFinder> cut_finder(const FeedInput& input,
                                                   const ToolPath& path,
                                                   const FeedCommandOptions& options);

/// A path with its feeds, and what summary and chart need of its cuts. The cuts themselves
/// and their loads are not kept: there may be millions, and they are in engagement.csv.
struct FedCuts {
    FedPath fed;                             ///< the path with its feeds
    FeedPlanTotals totals = {};              ///< of the plan
    std::vector<std::uint32_t> points = {};  ///< end point in the path of each cut
    std::vector<double> mu = {};             ///< rad, of each cut; NaN: unknown
    std::vector<double> pick_feed_mm = {};   ///< mm, of each cut; NaN: unknown
    std::vector<double> horizontal_mm =
        {};                       ///< mm, pick_feed_horizontal_mm; NaN: unknown
    std::size_t by_contact = 0;   ///< as SegmentCuts
    std::size_t by_passes = 0;    ///< as SegmentCuts
    std::size_t zero_length = 0;  ///< as SegmentCuts
    std::size_t between = 0;      ///< number of cuts with earlier passes on both sides
    std::size_t down = 0;  ///< number of cuts beside a pass or an edge, milled down
    std::size_t up = 0;    ///< the same, milled up
};

/// Plans the feeds, either from the geometry of the cuts or from the simulated stock.
/// \param cuts with `fed` only; receives the plan.
/// \param finder of the cuts of `cuts.fed`. It is released after its last use.
/// \param sink receives the rows of engagement.csv piece by piece, after its header; called
///        by any thread, one call at a time.
/// \throws GeometryError if no cut finds material in the stock; LimitError if the stock
///         needs more memory than the limit; also throws as `feed_plan`, and whatever
///         `sink` throws.
void plan_feeds(FedCuts& cuts, std::unique_ptr<const SegmentCutFinder> finder,
                const FeedInput& input, const FeedCommandOptions& options,
                const std::function<void(std::string_view piece)>& sink);

}  // namespace endmill
