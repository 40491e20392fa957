// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
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

/// A value of each cutting move by its number; nothing where it is unknown.
using MoveValue = std::function<std::optional<double>(std::size_t move)>;

/// What the chart shows of `count` moves. Each function is called once or twice for each
/// move.
struct FeedCurves {
    std::size_t count;                             ///< number of moves
    std::function<double(std::size_t)> length_mm;  ///< mm
    MoveValue mu;                                  ///< rad, slope of the pick feed
    MoveValue lambda;                              ///< rad, slope of the feed
    MoveValue pick_feed_mm;                        ///< mm, between ball centres
    MoveValue pick_feed_horizontal_mm;             ///< mm
    MoveValue depth_mm;         ///< mm, of the tip below the top of the stock
    MoveValue feed_mm_per_min;  ///< mm/min
    MoveValue spindle_rpm;      ///< rpm
    std::function<FeedLimit(std::size_t)> limit;         ///< what limits the feed
    std::function<SpeedLimit(std::size_t)> speed_limit;  ///< what limits the speed
};

/// The same chart of moves that are not kept as rows.
/// \throws DomainError unless every number is finite.
std::string feed_svg(const FeedCurves& curves, const FeedFigure& figure);

}  // namespace endmill
