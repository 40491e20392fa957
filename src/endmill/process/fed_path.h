// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// A path with the feeds of a plan, and the machining time: block by block at the
/// programmed feeds, or with the acceleration limit of a machine.
///
/// Implemented in `fed_path.cpp` (the path), `feed_times.cpp` (times at programmed feeds)
/// and `planned_feed.cpp` (a machine of limited acceleration).

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/path/tool_path.h"
#include "endmill/process/feed_limits.h"

namespace endmill {

/// The path with a feed and a spindle speed on every row. Planned moves get the values of
/// `rows`. Other moves keep their feed, or get `plunge_feed_mm_per_min` if they have
/// none; rapids have no feed. Their spindle speed is that of the next planned move, or of
/// the last one if no planned move follows.
/// Source: docs/methods/ball-end-milling.md, sections 12 and 13.
/// \param path the path.
/// \param points indices of the end points of the planned moves, ascending.
/// \param rows the planned feeds, one per entry of `points`.
/// \param plunge_feed_mm_per_min mm/min, above 0.
/// \throws DomainError unless there is one row per point, the points are ascending and
///         exist, and the feed is finite and above 0.
ToolPath fed_path(ToolPath path, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows, double plunge_feed_mm_per_min);

/// Name of the reported limit for each of `count` points; empty for points that are not
/// among `points`. Parameters and errors are those of `fed_path`.
std::vector<std::string_view> limit_words(std::size_t count,
                                          std::span<const std::size_t> points,
                                          std::span<const SegmentFeed> rows);

/// Time in min of the non-cutting moves: the moves of `fed` whose end points are not
/// among `points`. Moves without a feed run at `rapid_mm_per_min`.
/// \throws DomainError unless the rapid feed is finite and above 0.
double noncut_minutes(const ToolPath& fed, std::span<const std::size_t> points,
                      double rapid_mm_per_min);

/// A path that receives its feeds block by block, in place, for a path of millions of
/// moves. The blocks together have the result of `fed_path`.
class FedPath {
public:
    /// A path without planned moves.
    explicit FedPath(ToolPath path);

    const ToolPath& path() const { return path_; }   ///< with the feeds so far
    ToolPath take() && { return std::move(path_); }  ///< the path itself

    /// Sets feed, speed and limits of planned moves.
    /// \param points indices of their end points, ascending, after those of earlier calls.
    /// \param rows the planned feeds, one per entry of `points`.
    /// \throws DomainError unless there is one row per point, and the points are ascending
    ///         and exist.
    void plan(std::span<const std::size_t> points, std::span<const SegmentFeed> rows);

    /// Sets feed and speed of all other moves, as `fed_path` does.
    /// \throws DomainError unless the feed is finite and above 0.
    void complete(double plunge_feed_mm_per_min);

    /// Whether the move to a point of the path has been planned.
    bool is_planned(std::size_t point) const { return limits_[point] != not_planned; }

    /// The reported limit of a planned move. \pre is_planned(point)
    FeedLimit limit(std::size_t point) const
    {
        return static_cast<FeedLimit>(limits_[point] / limits_a_speed);
    }

    /// The limit of the spindle speed of a planned move. \pre is_planned(point)
    SpeedLimit speed_limit(std::size_t point) const
    {
        return static_cast<SpeedLimit>(limits_[point] % limits_a_speed);
    }

    /// Name of the reported limit; empty for a move that was not planned.
    std::string_view limit_word(std::size_t point) const
    {
        return is_planned(point) ? feed_limit_name(limit(point)) : std::string_view{};
    }

    /// Time in min of the moves that were not planned. Moves without a feed run at
    /// `rapid_mm_per_min`.
    /// \throws DomainError unless the rapid feed is finite and above 0.
    double noncut_minutes(double rapid_mm_per_min) const;

private:
    void set_other_feeds(double plunge_feed_mm_per_min);

    static constexpr unsigned limits_a_speed = 16;
    static constexpr unsigned char not_planned = 255;

    ToolPath path_;
    std::vector<unsigned char> limits_;  // of each point: both limits in one byte
    std::size_t next_ = 0;               // first point after those of `plan`
};

/// Times of a path, and the saving against one constant feed. Values that cannot be
/// computed are std::nullopt.
struct FeedTimes {
    double cut_min;                                ///< min, cutting moves
    std::optional<double> noncut_min = {};         ///< min, non-cutting moves and dwells
    std::optional<double> total_min = {};          ///< min, sum of both
    std::optional<double> constant_feed_min = {};  ///< min, total at the constant feed
    /// %, share of that total that is saved; negative if the varied feed takes longer.
    std::optional<double> saving_percent = {};
};

/// Data from which the times of a path follow.
struct TimeParts {
    double cut_length_mm;                                 ///< mm, above 0
    double cut_min;                                       ///< min, above 0
    std::optional<double> noncut_min = {};                ///< min, at least 0
    std::optional<double> constant_feed_mm_per_min = {};  ///< mm/min, above 0
};

/// The times of a path.
/// Source: [ParkMaeng, section 5]; docs/methods/ball-end-milling.md, section 8.
/// \throws DomainError if a part is outside its range or not finite.
FeedTimes feed_times(const TimeParts& parts);

/// Share of `constant_min` that `varied_min` saves, in %: 100 (1 - varied / constant).
/// \throws DomainError unless both are above 0.
double saving_percent(double varied_min, double constant_min);

/// Total time of a path on which all cuts have the same feed.
struct ConstantFeedRun {
    double feed_mm_per_min;  ///< mm/min, above 0
    double total_min;        ///< min, above 0
};

/// Parts of a total time: total = length / feed + noncut.
struct RunParts {
    double length_mm;   ///< mm, length of the cuts
    double noncut_min;  ///< min, time of all other motion
};

/// Length and noncutting time that follow from two runs of the same path at different
/// feeds. An error e of the total times causes an error of 2 e / |1/feed - 1/feed'| in
/// the length.
/// Source: docs/methods/ball-end-milling.md, section 8.
/// \throws DomainError unless feeds and times are above 0 and the feeds differ.
RunParts parts_of_runs(const ConstantFeedRun& one, const ConstantFeedRun& other);

/// Acceleration and corner rounding of a machine.
struct FeedAcceleration {
    double acceleration_mm_per_s2;  ///< mm/s^2, along the path and in corners, above 0
    double corner_tolerance_mm = 0.01;  ///< mm, largest deviation at a corner, above 0
};

/// Motion along a polyline, from rest to rest.
struct PlannedRun {
    std::vector<double> vertex_speeds;  ///< mm/s, at each point
    std::vector<double> segment_times;  ///< s, of each segment
    double time_s = 0;                  ///< s, their sum in order
};

/// Largest speed in mm/s at the corner between two moves. The machine rounds the corner
/// by the circle that is tangent to both moves, passes within the tolerance of the corner
/// and uses at most half of either move. The speed is infinite if the direction does not
/// change, and 0 if it is reversed.
///
/// With the cosine c and the sine s of half the angle of turning, the radius of the
/// circle is min(tolerance c (1 + c) / s^2, c / (2 s) least length), and speed^2 = a
/// radius.
/// Source: docs/methods/ball-end-milling.md, section 11.
/// \param before the move to the corner, mm, not 0.
/// \param after the move from the corner, mm, not 0.
/// \param motion acceleration and tolerance.
/// \throws DomainError unless tolerance and acceleration are above 0 and no length is 0.
double corner_speed(const Vec3& before, const Vec3& after,
                    const FeedAcceleration& motion);

/// Fastest motion along `points` from rest to rest. Its speed exceeds neither the feed of
/// a segment nor the speed of a corner. The rate of change of the speed does not exceed
/// the acceleration. Each vertex speed is the largest that both neighbours allow.
/// Therefore no motion within these bounds is faster.
/// Source: docs/methods/ball-end-milling.md, section 11.
///
/// \param points mm, at least two.
/// \param feeds mm/s, one per segment, above 0.
/// \param motion acceleration and tolerance.
/// \throws DomainError unless there are two points, all are finite, no two neighbours are
///         equal, and feeds and motion are in their ranges.
/// Relative error of the time below 1e-13 per segment. Time is linear in the points.
PlannedRun planned_run(std::span<const Vec3> points, std::span<const double> feeds,
                       const FeedAcceleration& motion);

/// Time in s of the move to each point of `path`; the first entry is 0. Each sequence of
/// consecutive moves at feed is planned along its tips, from rest to rest. A rapid or
/// another move without a feed has the time 0; the machine rests before and after it. A
/// move of length 0 has the time 0.
/// \throws DomainError unless every cut has a feed, or as `planned_run`.
std::vector<double> planned_times(const ToolPath& path, const FeedAcceleration& motion);

}  // namespace endmill
