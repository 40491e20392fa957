// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/body_place.h"

#include <algorithm>
#include <cmath>

namespace endmill {
namespace {

// Limit of Newton's iteration. Five steps suffice except at a double root.
constexpr int most_steps = 60;

// A place relative to a cylinder on a move, as a function of the axis position u along
// the move.
struct Passing {
    double height;  // height of the place over the lower end at u = 0, mm
    double slope;   // of the move
    double radius;  // mm
    double s;       // position of the place along the move, mm
    double e;       // position across the move, mm

    // Height of the place over the cylinder's lower end, mm.
    double over_end(double u) const { return height - slope * u; }
    // Distance of the place from the axis, mm.
    double from_axis(double u) const { return std::sqrt(e * e + (s - u) * (s - u)); }
    // Distance of the place from the rim, mm; negative outside.
    double from_rim(double u) const { return radius - from_axis(u); }

    // Returns the u where height and distance from the rim are equal, between a u at
    // which the height is greater and one at which it is less. Their difference is
    // convex, so Newton's steps never pass the root.
    double crossing(double u, double beyond) const
    {
        const auto [low, high] = std::minmax(u, beyond);
        for (int step = 0; step < most_steps; ++step) {
            const double away = from_axis(u);
            const double rate = (away > 0 ? (u - s) / away : 0) - slope;
            const double next =
                std::clamp(u - (over_end(u) - from_rim(u)) / rate, low, high);
            if (!std::isfinite(next) || next == u)
                break;
            u = next;
        }
        return u;
    }
};

}  // namespace

BodyPlace place_in_body(const BodyCylinder& body, const SweptMove& move,
                        const Vec3& place)
{
    const double dx = place.x() - move.x;
    const double dy = place.y() - move.y;
    const Passing passing{place.z() - move.z - body.above, move.slope, body.radius,
                          dx * move.direction_x + dy * move.direction_y,
                          dy * move.direction_x - dx * move.direction_y};
    const auto inwards = [&](double u) {
        const double away = passing.from_axis(u);
        return away > 0 ? Vec3{(move.x + u * move.direction_x - place.x()) / away,
                               (move.y + u * move.direction_y - place.y()) / away, 0}
                        : Vec3{0, 0, 0};
    };
    const double nearest = std::clamp(passing.s, 0.0, move.length);
    if (passing.over_end(nearest) >= passing.from_rim(nearest))
        return {passing.from_rim(nearest), inwards(nearest)};
    const double lowest = move.slope > 0 ? 0 : move.length;
    if (passing.from_rim(lowest) >= passing.over_end(lowest))
        return {passing.over_end(lowest), Vec3::UnitZ()};
    if (move.slope == 0)
        return {passing.over_end(nearest), Vec3::UnitZ()};
    const double u = passing.crossing(lowest, nearest);
    const double away = passing.from_axis(u);
    const double outwards = away > 0 ? (passing.s - u) / away : 0;
    const double share = outwards / (outwards + move.slope);
    return {passing.over_end(u), share * Vec3::UnitZ() + (1 - share) * inwards(u)};
}

}  // namespace endmill
