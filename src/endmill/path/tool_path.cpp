// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/path/tool_path.h"

#include <algorithm>

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
        case Move::Plunge:
            return totals.plunge_mm;
        case Move::Cut:
            break;
    }
    return totals.cut_mm;
}

}  // namespace

void PathTotalsSum::start(const Vec3& tip, std::optional<int> tool)
{
    if (!sum_.extent)
        sum_.extent = TipBox{tip, tip};
    sum_.extent->low = sum_.extent->low.cwiseMin(tip);
    sum_.extent->high = sum_.extent->high.cwiseMax(tip);
    std::vector<int>& tools = sum_.tools;
    if (!tool || (!tools.empty() && tools.back() == *tool))
        return;
    const auto place = std::ranges::lower_bound(tools, *tool);
    if (place == tools.end() || *place != *tool)
        tools.insert(place, *tool);
}

void PathTotalsSum::add(Move move, const Vec3& tip, const CuttingConditions& conditions,
                        double length_mm)
{
    start(tip, conditions.tool);
    length_of(sum_, move) += length_mm;
    if (move == Move::Rapid || length_mm == 0)
        return;
    if (!conditions.feed_mm_per_min) {
        is_timed_ = false;
        return;
    }
    const double minutes = length_mm / *conditions.feed_mm_per_min;
    minutes_ += minutes;
    if (move == Move::Plunge)
        sum_.plunge_time_min += minutes;
}

PathTotals PathTotalsSum::totals() const
{
    PathTotals totals = sum_;
    if (is_timed_ && minutes_ > 0)
        totals.time_min = minutes_;
    return totals;
}

PathTotals path_totals(const ToolPath& path)
{
    PathTotalsSum sum;
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const PathPoint& point = path.points[k];
        const Vec3& tip = point.location.tip;
        if (k == 0)
            sum.start(tip, point.conditions.tool);
        else
            sum.add(point.move, tip, point.conditions,
                    (tip - path.points[k - 1].location.tip).norm());
    }
    return sum.totals();
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
