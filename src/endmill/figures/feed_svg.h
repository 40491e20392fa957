// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "endmill/process/feed_limits.h"
#include "endmill/process/feed_plan.h"

namespace endmill {

/// What a picture of a feed plan says above its curves.
struct FeedFigure {
    std::string title = "Feed";              ///< at most 150 characters show
    std::vector<std::string> captions = {};  ///< ditto, each
};

/// Geometry and feed of each cutting move over the length of the cuts before and in it, as an
/// SVG file: mu and lambda; the pick feed and its horizontal part; the depth; the feed; the
/// spindle's speed.
/// Source: [ParkMaeng, fig. 8, 9].
/// \throws DomainError unless there is a row for each of `cuts`, and every number is finite.
std::string feed_svg(std::span<const SegmentCut> cuts, std::span<const SegmentFeed> rows,
                     const FeedFigure& figure);

}  // namespace endmill
