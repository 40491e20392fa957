// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/free_lengths.h"

#include <algorithm>
#include <limits>

namespace endmill {
namespace {

// Relative error of a free length that need not be measured. The empty ball at a
// neighbouring foot, a distance a away, is larger by at most a^2 / 2 divided by its
// radius.
constexpr double wanted_share = 0.01;

// Returns the radius of the largest ball that touches the foot and contains none of
// `places`; at most the way's length.
double ball_beside(const PartWay& way, std::span<const Vec3> places)
{
    double radius = way.length;
    for (const Vec3& place : places) {
        const Vec3 away = place - way.foot;
        const double over = away.dot(way.direction);
        if (2 * over * radius > away.squaredNorm())
            radius = away.squaredNorm() / (2 * over);
    }
    return radius;
}

}  // namespace

std::vector<FreeLength> free_lengths(std::span<const PartWay> ways,
                                     const PartDistance& distance,
                                     std::optional<std::size_t>& hint)
{
    std::vector<FreeLength> lengths;
    std::vector<Vec3> measured;  // feet of the measured ways
    std::vector<Vec3> met;       // places that limit the measured lengths
    for (const PartWay& whole : ways) {
        const PartWay way{whole.foot, whole.direction, ball_beside(whole, met)};
        // Squared distance of the nearest measured foot, mm^2.
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& foot : measured)
            nearest = std::min(nearest, (foot - way.foot).squaredNorm());
        if (nearest <= 2 * wanted_share * way.length * way.length) {
            lengths.push_back({way.length, false});
            continue;
        }
        const FreeBall ball = distance.free_ball(way, hint);
        // The known places lie on the triangulation too, so its error applies.
        const bool is_bounded = !ball.other && way.length < whole.length;
        const double spare = is_bounded ? distance.uncertainty() : 0;
        lengths.push_back({std::max(0.0, ball.length - spare), true});
        measured.push_back(way.foot);
        if (ball.other)
            met.push_back(*ball.other);
    }
    return lengths;
}

}  // namespace endmill
