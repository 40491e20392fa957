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

bool is_engaged(const BallEngagement& engagement, double latitude, double azimuth)
{
    if (is_air(engagement))
        return false;
    const EngagedRegion region{engagement};
    const double sine = std::sin(latitude);
    const double cosine = std::cos(latitude);
    return cosine >= region.top_cosine &&
           region.has({sine * std::sin(azimuth), sine * std::cos(azimuth), -cosine});
}

std::vector<AzimuthRange> engaged_ranges(const BallEngagement& engagement,
                                         double latitude)
{
    require_sound(engagement);
    require(latitude > 0 && latitude <= pi / 2,
            "engaged_ranges: need a latitude above 0, at most a right angle");
    if (is_air(engagement))
        return {};
    const EngagedRegion region{engagement};
    const double cosine = std::cos(latitude);
    if (cosine < region.top_cosine)
        return {};
    return region.ranges_at(std::sin(latitude), cosine);
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

double engaged_angle(const BallEngagement& engagement)
{
    require_sound(engagement);
    if (is_air(engagement))
        return 0;
    const EngagedRegion region{engagement};
    double angle = 0;
    for (const AzimuthRange& range : region.ranges_at(region.top_sine, region.top_cosine))
        angle += range.to - range.from;
    return angle;
}

}  // namespace endmill
