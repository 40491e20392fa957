// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/process/feed_limits.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// Title and captions of the chart of a feed plan.
struct FeedFigure {
    std::string title = "Feed";  ///< above the curves; cut after 150 characters
    std::vector<std::string> captions = {};  ///< lines below the title; cut after 150
};

/// Geometry and feed of each cutting move over the length of cut, as an SVG file. Five
/// panels show the angles mu and lambda, the pick feed and its horizontal component, the
/// depth, the feed, and the spindle speed. Below them two strips show where which limit
/// governs feed and spindle speed.
/// Source: after [ParkMaeng, fig. 8, 9].
/// \throws DomainError unless there is one row for each of `cuts` and every number is
///         finite.
std::string feed_svg(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const FeedFigure& figure);

}  // namespace endmill
