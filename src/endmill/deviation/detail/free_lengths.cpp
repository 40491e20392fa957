// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/free_lengths.h"

#include <algorithm>
#include <limits>

namespace endmill {
namespace {

// Of a free length: how closely it has to be known where it is not measured. The ball
// through a place that bounds another, a distance a away, is larger by a^2 / 2 over its
// radius or less.
constexpr double wanted_share = 0.01;

// The radius of the largest ball that touches the foot and holds none of `places`; at most
// the way's length.
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
    std::vector<Vec3> measured;  // feet
    std::vector<Vec3> met;       // places that bound the lengths over them
    for (const PartWay& whole : ways) {
        const PartWay way{whole.foot, whole.direction, ball_beside(whole, met)};
        double nearest = std::numeric_limits<double>::infinity();  // squared, mm^2
        for (const Vec3& foot : measured)
            nearest = std::min(nearest, (foot - way.foot).squaredNorm());
        if (nearest <= 2 * wanted_share * way.length * way.length) {
            lengths.push_back({way.length, false});
            continue;
        }
        const FreeBall ball = distance.free_ball(way, hint);
        // The places met are of the triangulation too.
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
