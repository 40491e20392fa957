// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/economy.h"

#include <algorithm>

#include "endmill/core/error.h"

namespace endmill {
namespace {

void add_move(Travel& travel, const PathPoint& from, const PathPoint& to)
{
    travel.contact_mm += (to.contact->contact.point - from.contact->contact.point).norm();
    travel.tip_mm += (to.location.tip - from.location.tip).norm();
}

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
        if (point.contact)
            ++economy.ncl;
        if (point.move == Move::Cut)
            add_move(economy.cut, *previous, point);
        if (point.move == Move::Link)
            add_move(economy.link, *previous, point);
        previous = &point;
    }
    return economy;
}

DirectionComparison compare_directions(const DirectionCost& u, const DirectionCost& v)
{
    require(u.ncl > 0 && v.ncl > 0 && u.tcd_mm > 0 && v.tcd_mm > 0,
            "compare_directions: counts and lengths must be positive");
    const bool v_is_better =
        v.tcd_mm < u.tcd_mm || (v.tcd_mm == u.tcd_mm && v.ncl < u.ncl);
    return {v_is_better ? Parameter::V : Parameter::U,
            reduction(static_cast<double>(u.ncl), static_cast<double>(v.ncl)),
            reduction(u.tcd_mm, v.tcd_mm)};
}

}  // namespace endmill
