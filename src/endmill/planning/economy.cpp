// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/economy.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Whether a point lies on a link that has not reached its contact yet.
bool is_corner(const PathPoint* point)
{
    return point && point->move == Move::Link && !point->contact();
}

double contact_distance(const PathPoint& from, const PathPoint& to)
{
    return (to.contact()->contact.point - from.contact()->contact.point).norm();
}

// The relative difference of two positive numbers.
double reduction(double one, double other)
{
    return (std::max(one, other) - std::min(one, other)) / std::max(one, other);
}

}  // namespace

PathEconomy path_economy(const ToolPath& path)
{
    constexpr const char* message =
        "path_economy: a cut or link must lead from contact to contact";
    PathEconomy economy{0, 0, {0, 0}, {0, 0}};
    const PathPoint* previous = nullptr;
    const PathPoint* last_contact = nullptr;  // since the cutter was lifted
    for (const PathPoint& point : path.points) {
        const bool is_link = point.move == Move::Link;
        const bool is_at_feed = point.move == Move::Cut || is_link;
        require(is_link || !is_corner(previous), message);
        if (!previous || point.pass != previous->pass)
            ++economy.passes;
        if (point.contact() || is_link)
            ++economy.ncl;
        if (is_at_feed) {
            require(last_contact && (is_link || (previous->contact() && point.contact())),
                    message);
            Travel& travel = is_link ? economy.link : economy.cut;
            travel.tip_mm += (point.location.tip - previous->location.tip).norm();
            if (point.contact())
                travel.contact_mm += contact_distance(*last_contact, point);
        }
        if (point.contact())
            last_contact = &point;
        else if (!is_link)
            last_contact = nullptr;
        previous = &point;
    }
    require(!is_corner(previous), message);
    return economy;
}

double counted_travel(const PathEconomy& economy, TravelKind kind, CountedMoves moves)
{
    const auto length = [kind](const Travel& travel) {
        return kind == TravelKind::Tip ? travel.tip_mm : travel.contact_mm;
    };
    const double cut = length(economy.cut);
    return moves == CountedMoves::CutsAndLinks ? cut + length(economy.link) : cut;
}

DirectionComparison compare_directions(const DirectionCost& u, const DirectionCost& v)
{
    const auto is_cost = [](const DirectionCost& cost) {
        return cost.ncl > 0 && cost.tcd_mm > 0 && std::isfinite(cost.tcd_mm);
    };
    require(is_cost(u) && is_cost(v),
            "compare_directions: counts and lengths must be positive and finite");
    const bool v_is_better =
        v.tcd_mm < u.tcd_mm || (v.tcd_mm == u.tcd_mm && v.ncl < u.ncl);
    return {v_is_better ? Parameter::V : Parameter::U,
            reduction(static_cast<double>(u.ncl), static_cast<double>(v.ncl)),
            reduction(u.tcd_mm, v.tcd_mm)};
}

}  // namespace endmill
