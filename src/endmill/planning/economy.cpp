// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/economy.h"

#include <algorithm>
#include <cmath>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Adds the lengths of the straight move between two points with contacts.
void add_move(Travel& travel, const PathPoint& from, const PathPoint& to)
{
    travel.contact_mm +=
        (to.contact()->contact.point - from.contact()->contact.point).norm();
    travel.tip_mm += (to.location.tip - from.location.tip).norm();
}

// Whether a move leads across an arch, between its retract and its plunge.
bool is_arch(const PathPoint* previous, const PathPoint& point)
{
    return previous && previous->move == Move::Retract && point.move == Move::Link &&
           !point.contact();
}

// The relative difference of two positive numbers.
double reduction(double one, double other)
{
    return (std::max(one, other) - std::min(one, other)) / std::max(one, other);
}

}  // namespace

PathEconomy path_economy(const ToolPath& path)
{
    PathEconomy economy{0, 0, {0, 0}, {0, 0}};
    const PathPoint* previous = nullptr;
    for (const PathPoint& point : path.points) {
        if (!previous || point.pass != previous->pass)
            ++economy.passes;
        if (point.contact())
            ++economy.ncl;
        if ((point.move == Move::Cut || point.move == Move::Link) &&
            !is_arch(previous, point)) {
            require(previous && previous->contact() && point.contact(),
                    "path_economy: a cut or link must lead from contact to contact");
            add_move(point.move == Move::Cut ? economy.cut : economy.link, *previous,
                     point);
        }
        previous = &point;
    }
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
