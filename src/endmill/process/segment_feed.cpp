// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/feed_limits.h"

#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {

void require_sound(const FeedRules& rules)
{
    require_sound(rules.model.material);
    require(std::isfinite(rules.model.radius) && rules.model.radius > 0,
            "FeedRules: need 0 < radius");
    for (const auto& limit :
         {rules.limits.cutting_force_n, rules.limits.thrust_n, rules.limits.torque_n_m})
        require(!limit || (std::isfinite(*limit) && *limit > 0),
                "FeedRules: need 0 < limit");
    require_sound(rules.range);
    require_sound(rules.drive);
}

SegmentFeed segment_feed(const SegmentLoad& load, const FeedRules& rules)
{
    const ToothFeed tooth = tooth_feed(load.bounds, rules.range);
    const CuttingLoads loads =
        load.loads ? load.loads(tooth.feed_per_tooth_mm) : CuttingLoads{};
    const TableFeed table =
        table_feed({tooth.feed_per_tooth_mm, load.engaged_angle / std::numbers::pi,
                    loads.torque_n_m, load.length_mm},
                   rules.drive);
    return {load.engaged_angle, tooth, load.peak_factor, loads, table};
}

FeedLimit said_limit(const SegmentFeed& feed)
{
    if (feed.tooth.is_infeasible)
        return FeedLimit::Infeasible;
    return feed.table.is_block_bound ? FeedLimit::BlockRate : feed.tooth.governing;
}

}  // namespace endmill
