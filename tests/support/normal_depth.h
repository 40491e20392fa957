// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "swept_deviation.h"

// The depth that a ball removes along the part's normals at its border, by brute force:
// samples, and bisection for the point where the normal leaves the balls.
namespace endmill::test {

/// Returns the depth in mm that the ball removes along -`normal` from `point`, which it
/// clears.
inline double normal_depth(const SampledMove& move, double radius, const Vec3& point,
                           const Vec3& normal)
{
    double inside = 0;
    double outside = 4 * radius + (move.to - move.from).norm();
    for (int k = 0; k < 60; ++k) {
        const double middle = (inside + outside) / 2;
        const bool is_inside = distance_to(point - middle * normal, move) < radius;
        (is_inside ? inside : outside) = middle;
    }
    return inside;
}

/// Calls `look(point, normal)` at `count` + 1 places along each side of a surface.
/// \param inset distance of the places from the side, as a share of the surface's
///        parameters.
template <class Look>
void for_each_beside_border(const Surface& surface, const Vec3& axis, int count,
                            double inset, const Look& look)
{
    const double side = tool_side_sign(surface, axis);
    const Interval u = surface.range(Parameter::U);
    const Interval v = surface.range(Parameter::V);
    for (int k = 0; k <= count; ++k)
        for (const double end : {inset, 1 - inset})
            for (const bool is_along_u : {true, false}) {
                const double share = std::clamp(k / double(count), inset, 1 - inset);
                const SurfaceTangents at =
                    surface.tangents(std::lerp(u.low, u.high, is_along_u ? share : end),
                                     std::lerp(v.low, v.high, is_along_u ? end : share));
                look(at.point, Vec3{side * at.du.cross(at.dv).normalized()});
            }
}

/// Returns the greatest depth in mm that `path` removes along the normals beside the
/// border. Shanks are ignored.
inline double border_depth(const Surface& surface, const ToolPath& path, double radius,
                           int count, double inset)
{
    const std::vector<SampledMove> moves = feed_moves(path, radius);
    double deepest = 0;
    for_each_beside_border(
        surface, path.points.front().location.axis, count, inset,
        [&](const Vec3& point, const Vec3& normal) {
            for (const SampledMove& move : moves)
                if (distance_to(point, move) < radius)
                    deepest =
                        std::max(deepest, normal_depth(move, radius, point, normal));
        });
    return deepest;
}

}  // namespace endmill::test
