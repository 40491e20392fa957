// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"
#include "endmill/process/feed_limits.h"

namespace endmill {

/// `path` with feed and spindle speed on every row. The moves to `points` (rising) have
/// those of `rows`. Other moves keep the feed that they have, or else get
/// `plunge_feed_mm_per_min`; rapids keep having none. The spindle turns on each of them
/// as in the next cut, or the last.
/// Source: spec of ball-end milling, sections 12 and 13.
/// \throws DomainError unless there is a row for each of the points, these are of the
///         path and rise, and the feed is finite and above 0.
ToolPath fed_path(ToolPath path, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows, double plunge_feed_mm_per_min);

/// The word for the limit that governs the move to each of `count` points; empty for
/// those that are not of `points`.
/// \throws DomainError as above.
std::vector<std::string_view> limit_words(std::size_t count,
                                          std::span<const std::size_t> points,
                                          std::span<const SegmentFeed> rows);

/// Minutes that the moves of `fed` to other points than `points` take: those without a
/// feed at `rapid_mm_per_min`, the others at theirs.
/// \throws DomainError unless the rapid feed is finite and above 0.
double noncut_minutes(const ToolPath& fed, std::span<const std::size_t> points,
                      double rapid_mm_per_min);

/// How long a path takes, and what a varied feed saves against one for all moves. What
/// cannot be told is none.
struct FeedTimes {
    double cut_min;
    std::optional<double> noncut_min = {};         ///< approaches, returns, dwells
    std::optional<double> total_min = {};          ///< both
    std::optional<double> constant_feed_min = {};  ///< the total at the constant feed
    std::optional<double> saving_percent = {};     ///< of that; negative: it takes longer
};

/// What the times are made of.
struct TimeParts {
    double cut_length_mm;                                 ///< above 0
    double cut_min;                                       ///< above 0
    std::optional<double> noncut_min = {};                ///< from 0
    std::optional<double> constant_feed_mm_per_min = {};  ///< above 0
};

/// The times of a path. Source: [ParkMaeng, section 5]; spec of ball-end milling, section
/// 8.
/// \throws DomainError unless the parts are finite and as said.
FeedTimes feed_times(const TimeParts& parts);

/// The share of `constant_min` that `varied_min` saves, in %: 100 (1 - varied /
/// constant).
/// \throws DomainError unless both are above 0.
double saving_percent(double varied_min, double constant_min);

/// The total time of one path at one feed for all of its cuts.
struct ConstantFeedRun {
    double feed_mm_per_min;  ///< above 0
    double total_min;        ///< above 0
};

/// What a total time is made of: total = length / feed + noncut.
struct RunParts {
    double length_mm;
    double noncut_min;
};

/// The length and the time besides that two runs of the same path tell. An error e of the
/// totals makes one of 2 e / |1/feed - 1/feed'| in the length.
/// Source: spec of ball-end milling, section 8.
/// \throws DomainError unless the runs are as said and of different feeds.
RunParts parts_of_runs(const ConstantFeedRun& one, const ConstantFeedRun& other);

/// How a machine follows a path.
struct FeedAcceleration {
    double acceleration_mm_per_s2;  ///< along the path, and across it in corners; above 0
    double corner_tolerance_mm = 0.01;  ///< by which a corner may be cut; above 0
};

/// The motion along a polyline, from rest to rest.
struct PlannedRun {
    std::vector<double> vertex_speeds;  ///< mm/s, at each point
    std::vector<double> segment_times;  ///< s, of each segment
    double time_s = 0;                  ///< their sum, in order
};

/// Fastest speed in mm/s over the corner from `before` to `after`, two moves with the
/// corner between them: that of the circle which touches both, passes within the
/// tolerance of the corner and uses no more than half of either move. Infinite if the
/// direction stays, 0 if it is reversed.
/// Source: spec of ball-end milling, section 11; with half the turn's cosine c and sine
/// s, radius = min(tolerance c (1 + c) / s^2, c / (2 s) least length), speed^2 = a
/// radius.
/// \param before, after in mm, of any length but 0.
/// \throws DomainError unless tolerance and acceleration are as said and no length is 0.
double corner_speed(const Vec3& before, const Vec3& after,
                    const FeedAcceleration& motion);

/// Fastest motion along `points` whose speed is nowhere above that of its segment, nor at
/// a point above the corner's, and changes no faster than the acceleration. Each speed at
/// a point is the largest that both neighbours allow, so no motion within these bounds
/// takes less time.
/// Source: spec of ball-end milling, section 11.
///
/// \param points in mm. \param feeds in mm/s, one a segment, above 0.
/// \throws DomainError unless there are two points, finite and no two neighbours equal,
///         and feeds and motion are as said.
/// Relative error of the time below 1e-13 a segment. Linear in the points.
PlannedRun planned_run(std::span<const Vec3> points, std::span<const double> feeds,
                       const FeedAcceleration& motion);

/// Times in s of the moves of `path`, one a point, that to the first 0. Each run of moves
/// at feed is planned by its tips from rest to rest; a rapid, and what else but a cut has
/// no feed, has 0 and makes the machine rest before and after. A move that goes nowhere
/// has 0.
/// \throws DomainError unless every cut has a feed; or as `planned_run`.
std::vector<double> planned_times(const ToolPath& path, const FeedAcceleration& motion);

}  // namespace endmill
