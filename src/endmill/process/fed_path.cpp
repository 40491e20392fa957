// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Checks the end points of the planned moves and their rows.
void require_rows(std::size_t count, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows)
{
    require(points.size() == rows.size(), "fed_path: need one row per point");
    require(std::ranges::is_sorted(points, std::less_equal<>{}) &&
                (points.empty() || points.back() < count),
            "fed_path: need ascending points of the path");
}

void require_feed(double feed, const char* what)
{
    require(std::isfinite(feed) && feed > 0, what);
}

}  // namespace

FedPath::FedPath(ToolPath path)
    : path_{std::move(path)},
      limits_(path_.points.size(), not_planned)
{
}

void FedPath::plan(std::span<const std::size_t> points, std::span<const SegmentFeed> rows)
{
    require_rows(path_.points.size(), points, rows);
    require(points.empty() || next_ <= points.front(),
            "fed_path: need ascending points of the path");
    for (std::size_t k = 0; k < points.size(); ++k) {
        const SegmentFeed& row = rows[k];
        CuttingConditions& conditions = path_.points[points[k]].conditions;
        conditions.feed_mm_per_min = row.table.feed_mm_per_min;
        conditions.spindle_rpm = row.table.spindle_rpm;
        limits_[points[k]] = static_cast<unsigned char>(
            limits_a_speed * static_cast<unsigned>(reported_limit(row)) +
            static_cast<unsigned>(row.table.speed_limit));
        next_ = points[k] + 1;
    }
}

void FedPath::complete(double plunge_feed_mm_per_min)
{
    require_feed(plunge_feed_mm_per_min, "fed_path: need 0 < plunge feed");
    std::vector<PathPoint>& points = path_.points;
    if (next_ == 0) {
        set_other_feeds(plunge_feed_mm_per_min);
        return;
    }
    // From the end of the path on, the speed is that of the last planned move.
    std::optional<double> speed = points[next_ - 1].conditions.spindle_rpm;
    for (std::size_t i = points.size(); i-- > 0;)
        if (is_planned(i))
            speed = points[i].conditions.spindle_rpm;
        else
            points[i].conditions.spindle_rpm = speed;
    set_other_feeds(plunge_feed_mm_per_min);
}

void FedPath::set_other_feeds(double plunge_feed_mm_per_min)
{
    for (std::size_t i = 0; i < path_.points.size(); ++i) {
        std::optional<double>& feed = path_.points[i].conditions.feed_mm_per_min;
        if (is_planned(i))
            continue;
        if (path_.points[i].move == Move::Rapid)
            feed.reset();
        else if (!feed)
            feed = plunge_feed_mm_per_min;
    }
}

double FedPath::noncut_minutes(double rapid_mm_per_min) const
{
    require_feed(rapid_mm_per_min, "noncut_minutes: need 0 < rapid feed");
    double minutes = 0;
    for (std::size_t i = 1; i < path_.points.size(); ++i) {
        if (is_planned(i))
            continue;
        const PathPoint& point = path_.points[i];
        const double length =
            (point.location.tip - path_.points[i - 1].location.tip).norm();
        minutes += length / point.conditions.feed_mm_per_min.value_or(rapid_mm_per_min);
    }
    return minutes;
}

ToolPath fed_path(ToolPath path, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows, double plunge_feed_mm_per_min)
{
    FedPath fed{std::move(path)};
    fed.plan(points, rows);
    fed.complete(plunge_feed_mm_per_min);
    return std::move(fed).take();
}

std::vector<std::string_view> limit_words(std::size_t count,
                                          std::span<const std::size_t> points,
                                          std::span<const SegmentFeed> rows)
{
    require_rows(count, points, rows);
    std::vector<std::string_view> words(count);
    for (std::size_t k = 0; k < points.size(); ++k)
        words[points[k]] = feed_limit_name(reported_limit(rows[k]));
    return words;
}

double noncut_minutes(const ToolPath& fed, std::span<const std::size_t> points,
                      double rapid_mm_per_min)
{
    require_feed(rapid_mm_per_min, "noncut_minutes: need 0 < rapid feed");
    double minutes = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < fed.points.size(); ++i) {
        if (next < points.size() && points[next] == i) {
            ++next;
            continue;
        }
        if (i == 0)
            continue;
        const double length =
            (fed.points[i].location.tip - fed.points[i - 1].location.tip).norm();
        const auto& feed = fed.points[i].conditions.feed_mm_per_min;
        minutes += length / feed.value_or(rapid_mm_per_min);
    }
    return minutes;
}

}  // namespace endmill
