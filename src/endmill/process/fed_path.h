// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/path/tool_path.h"
#include "endmill/process/segment_feed.h"

namespace endmill {

/// `path` with feed and spindle speed on every row. The moves to `points` (rising) have those
/// of `rows`. Other moves keep the feed that they have, or else get `plunge_feed_mm_per_min`;
/// rapids keep having none. The spindle turns on each of them as in the next cut, or the last.
/// Source: spec of ball-end milling, sections 12 and 13.
/// \throws DomainError unless there is a row for each of the points, these are of the path and
///         rise, and the feed is finite and above 0.
ToolPath fed_path(ToolPath path, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows, double plunge_feed_mm_per_min);

/// The word for the limit that governs the move to each of `count` points; empty for those
/// that are not of `points`.
/// \throws DomainError as above.
std::vector<std::string_view> limit_words(std::size_t count,
                                          std::span<const std::size_t> points,
                                          std::span<const SegmentFeed> rows);

/// Minutes that the moves of `fed` to other points than `points` take: those without a feed
/// at `rapid_mm_per_min`, the others at theirs.
/// \throws DomainError unless the rapid feed is finite and above 0.
double noncut_minutes(const ToolPath& fed, std::span<const std::size_t> points,
                      double rapid_mm_per_min);

}  // namespace endmill
