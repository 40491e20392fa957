// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "endmill/core/detail/units.h"
#include "endmill/core/error.h"

// The motion is planned in three passes over the points
// (docs/methods/ball-end-milling.md, section 11):
// 1. The speed at a point is at most the feed of its two segments and the corner speed.
// 2. A forward pass reduces it to what can be reached from the previous point.
// 3. A backward pass reduces it to what allows stopping at the next point.
// The time of each segment then follows in closed form from its feed and its two end
// speeds.

namespace endmill {
namespace {

void require_sound(const FeedAcceleration& motion)
{
    require(
        std::isfinite(motion.acceleration_mm_per_s2) && motion.acceleration_mm_per_s2 > 0,
        "planned feed: need 0 < acceleration");
    require(std::isfinite(motion.corner_tolerance_mm) && motion.corner_tolerance_mm > 0,
            "planned feed: need 0 < corner tolerance");
}

// The segments of a polyline.
struct Segments {
    std::vector<Vec3> moves;      // mm
    std::vector<double> lengths;  // mm
};

Segments segments_of(std::span<const Vec3> points)
{
    Segments segments;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const Vec3 move = points[i] - points[i - 1];
        const double length = move.norm();
        require(std::isfinite(length) && length > 0,
                "planned_run: need finite points without equal neighbours");
        segments.moves.push_back(move);
        segments.lengths.push_back(length);
    }
    return segments;
}

// The largest speed that can be reached from `speed` over `length`.
double reached(double speed, double length, double acceleration)
{
    return std::sqrt(speed * speed + 2 * acceleration * length);
}

// Largest speed at each point: the minimum of the feeds of both segments and the corner
// speed, then reduced forwards and backwards to what the acceleration allows from the
// rests at both ends.
std::vector<double> vertex_speeds(const Segments& segments, std::span<const double> feeds,
                                  const FeedAcceleration& motion)
{
    const std::size_t count = segments.lengths.size();
    std::vector<double> speeds(count + 1, 0);
    for (std::size_t j = 1; j < count; ++j)
        speeds[j] =
            std::min({feeds[j - 1], feeds[j],
                      corner_speed(segments.moves[j - 1], segments.moves[j], motion)});
    const double a = motion.acceleration_mm_per_s2;
    for (std::size_t j = 0; j < count; ++j)
        speeds[j + 1] =
            std::min(speeds[j + 1], reached(speeds[j], segments.lengths[j], a));
    for (std::size_t j = count; j-- > 0;)
        speeds[j] = std::min(speeds[j], reached(speeds[j + 1], segments.lengths[j], a));
    return speeds;
}

// Time of a segment: the machine accelerates from `from`, runs at `feed` as far as the
// length allows, and slows down to `to`.
double segment_time(double length, double from, double to, double feed, double a)
{
    const double peak =
        std::min(feed, std::sqrt((2 * a * length + from * from + to * to) / 2));
    const double ramps = (2 * peak * peak - from * from - to * to) / (2 * a);
    // Rounding may make a ramp or the part at constant speed slightly negative.
    return std::max(0.0, peak - from) / a + std::max(0.0, peak - to) / a +
           std::max(0.0, length - ramps) / peak;
}

// Feed in mm/s of the move to point i, or std::nullopt for a rapid.
std::optional<double> feed_of_move(const ToolPath& path, std::size_t i)
{
    const Move move = path.points[i].move;
    const auto feed =
        move == Move::Rapid ? std::nullopt : path.points[i].conditions.feed_mm_per_min;
    require(feed || move != Move::Cut, "planned_times: need a feed for each cut");
    return feed ? std::optional{*feed / seconds_per_min} : std::nullopt;
}

// A run of consecutive moves at feed.
struct Run {
    std::vector<Vec3> tips = {};
    std::vector<double> feeds = {};
    std::vector<std::size_t> ends = {};  // indices of the end points of the moves
};

// Plans `run` and stores the times of its moves.
void finish(const Run& run, const FeedAcceleration& motion, std::vector<double>& times)
{
    if (run.feeds.empty())
        return;
    const PlannedRun planned = planned_run(run.tips, run.feeds, motion);
    for (std::size_t k = 0; k < run.ends.size(); ++k)
        times[run.ends[k]] = planned.segment_times[k];
}

}  // namespace

double corner_speed(const Vec3& before, const Vec3& after, const FeedAcceleration& motion)
{
    require_sound(motion);
    const double length_before = before.norm();
    const double length_after = after.norm();
    require(length_before > 0 && length_after > 0, "corner_speed: need 0 < lengths");
    const Vec3 in = before / length_before;
    const Vec3 out = after / length_after;
    // Cosine and sine of half the angle of turning. The cosine is exactly 0 for a
    // reversal.
    const double cosine = (in + out).norm() / 2;
    const double sine = (in - out).norm() / 2;
    if (sine == 0)
        return std::numeric_limits<double>::infinity();
    const double by_tolerance =
        motion.corner_tolerance_mm * cosine * (1 + cosine) / (sine * sine);
    const double by_length = std::min(length_before, length_after) * cosine / (2 * sine);
    return std::sqrt(motion.acceleration_mm_per_s2 * std::min(by_tolerance, by_length));
}

PlannedRun planned_run(std::span<const Vec3> points, std::span<const double> feeds,
                       const FeedAcceleration& motion)
{
    require_sound(motion);
    require(points.size() >= 2, "planned_run: need two points");
    require(feeds.size() + 1 == points.size(), "planned_run: need one feed per segment");
    for (const double feed : feeds)
        require(std::isfinite(feed) && feed > 0, "planned_run: need 0 < feed");
    const Segments segments = segments_of(points);
    PlannedRun run;
    run.vertex_speeds = vertex_speeds(segments, feeds, motion);
    for (std::size_t j = 0; j < feeds.size(); ++j) {
        run.segment_times.push_back(segment_time(
            segments.lengths[j], run.vertex_speeds[j], run.vertex_speeds[j + 1], feeds[j],
            motion.acceleration_mm_per_s2));
        run.time_s += run.segment_times.back();
    }
    return run;
}

std::vector<double> planned_times(const ToolPath& path, const FeedAcceleration& motion)
{
    require_sound(motion);
    std::vector<double> times(path.points.size(), 0);
    Run run;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        const Vec3& tip = path.points[i].location.tip;
        const Vec3& before = path.points[i - 1].location.tip;
        const auto feed = feed_of_move(path, i);
        if (!feed) {
            finish(run, motion, times);
            run = Run{};
        } else if (tip != before) {
            if (run.tips.empty())
                run.tips.push_back(before);
            run.tips.push_back(tip);
            run.feeds.push_back(*feed);
            run.ends.push_back(i);
        }
    }
    finish(run, motion, times);
    return times;
}

}  // namespace endmill
