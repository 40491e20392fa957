// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

#include <set>

namespace endmill {

std::string_view move_name(Move move)
{
    switch (move) {
        case Move::Cut:
            return "cut";
        case Move::Link:
            return "link";
        case Move::Rapid:
            return "rapid";
        case Move::Plunge:
            return "plunge";
        case Move::Retract:
            return "retract";
    }
    return {};
}

std::optional<Move> move_from_name(std::string_view name)
{
    for (const Move move :
         {Move::Cut, Move::Link, Move::Rapid, Move::Plunge, Move::Retract})
        if (move_name(move) == name)
            return move;
    return std::nullopt;
}

PathLengths path_lengths(const ToolPath& path)
{
    PathLengths lengths;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const bool is_at_feed = point.move == Move::Cut || point.move == Move::Link;
        (is_at_feed ? lengths.at_feed_mm : lengths.lifted_mm) +=
            (point.location.tip - path.points[k - 1].location.tip).norm();
    }
    return lengths;
}

namespace {

// The length of `totals` to which a move of this kind belongs.
double& length_of(PathTotals& totals, Move move)
{
    switch (move) {
        case Move::Rapid:
            return totals.rapid_mm;
        case Move::Link:
        case Move::Retract:
            return totals.link_mm;
        case Move::Cut:
        case Move::Plunge:
            break;
    }
    return totals.cut_mm;
}

// Time in min of the moves that are not rapids; nothing if one of them has no feed, or if
// there are none.
std::optional<double> time_at_feed(const ToolPath& path)
{
    double minutes = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const double length =
            (point.location.tip - path.points[k - 1].location.tip).norm();
        if (point.move == Move::Rapid || length == 0)
            continue;
        if (!point.conditions.feed_mm_per_min)
            return std::nullopt;
        minutes += length / *point.conditions.feed_mm_per_min;
    }
    return minutes > 0 ? std::optional{minutes} : std::nullopt;
}

}  // namespace

PathTotals path_totals(const ToolPath& path)
{
    PathTotals totals;
    std::set<int> tools;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const Vec3& tip = point.location.tip;
        if (k == 0)
            totals.extent = TipBox{tip, tip};
        else
            length_of(totals, point.move) +=
                (tip - path.points[k - 1].location.tip).norm();
        totals.extent->low = totals.extent->low.cwiseMin(tip);
        totals.extent->high = totals.extent->high.cwiseMax(tip);
        if (point.conditions.tool)
            tools.insert(*point.conditions.tool);
    }
    totals.time_min = time_at_feed(path);
    totals.tools.assign(tools.begin(), tools.end());
    return totals;
}

std::optional<double> entry_height(const ToolPath& path)
{
    for (std::size_t k = 1; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        if (point.move == Move::Rapid || point.move == Move::Retract)
            continue;
        const double from = path.points[k - 1].location.tip.z();
        return from > point.location.tip.z() ? std::optional{from} : std::nullopt;
    }
    return std::nullopt;
}

}  // namespace endmill
