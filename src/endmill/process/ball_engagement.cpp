// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/ball_engagement.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {

using std::numbers::pi;

void require_sound(const BallEngagement& engagement)
{
    require(std::abs(engagement.mu) < pi / 2 && std::abs(engagement.lambda) < pi / 2,
            "engagement: need angles mu and lambda below a right angle");
    require(std::isfinite(engagement.depth_ratio), "engagement: need a finite depth");
    require(std::isfinite(engagement.pick_feed_ratio) && engagement.pick_feed_ratio >= 0,
            "engagement: need a pick feed of 0 or more");
}

bool is_air(const BallEngagement& engagement)
{
    return engagement.depth_ratio <= 0 || (engagement.previous == PreviousPass::Beside &&
                                           engagement.pick_feed_ratio == 0);
}

double shank_angle(const BallEngagement& engagement)
{
    if (engagement.previous == PreviousPass::None)
        return pi;
    if (engagement.previous == PreviousPass::Edge)
        return pi / 2;
    return std::acos(
        std::max(-1.0, 1 - engagement.pick_feed_ratio * std::cos(engagement.mu)));
}

}  // namespace endmill
