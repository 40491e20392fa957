// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/fed_path.h"

#include <algorithm>
#include <cmath>
#include <functional>

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

ToolPath fed_path(ToolPath path, std::span<const std::size_t> points,
                  std::span<const SegmentFeed> rows, double plunge_feed_mm_per_min)
{
    require_rows(path.points.size(), points, rows);
    require_feed(plunge_feed_mm_per_min, "fed_path: need 0 < plunge feed");
    std::size_t next = 0;  // the planned move at this point or after it
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        CuttingConditions& conditions = path.points[i].conditions;
        const bool is_cut = next < points.size() && points[next] == i;
        if (!rows.empty())
            conditions.spindle_rpm =
                rows[std::min(next, rows.size() - 1)].table.spindle_rpm;
        if (is_cut)
            conditions.feed_mm_per_min = rows[next++].table.feed_mm_per_min;
        else if (path.points[i].move == Move::Rapid)
            conditions.feed_mm_per_min.reset();
        else if (!conditions.feed_mm_per_min)
            conditions.feed_mm_per_min = plunge_feed_mm_per_min;
    }
    return path;
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
