// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "endmill/core/vec.h"

namespace endmill {

/// The corner of a triangle on which a ball that is lowered comes to rest highest.
struct HighestCorner {
    int corner;
    double tip_z;  ///< on that corner, mm
    double bound;  ///< of the tip's height on the whole triangle; tip_z if that is it
};

/// Asks the corners only, which is soon done: the height is concave over the triangle, so
/// that its slopes along the two sides from a corner, drawn out, are above it, and that if
/// neither rises, the corner is what is touched.
///
/// Right to 1e-9 mm, for coordinates within 1e4 mm and radii within 1e3 mm.
/// Source: derived here.
/// \param corners, x, y, radius in mm, the ball's axis at (x, y).
/// \return nothing if all corners are outside the ball or near its rim, where rounding
///         tells.
inline std::optional<HighestCorner> highest_corner(const std::array<Vec3, 3>& corners,
                                                   double x, double y, double radius)
{
    constexpr double least_root = 1.0 / 16;  // of the radius: errors grow by its inverse
    std::array<Vec3, 3> local;
    std::array<double, 3> root;
    std::array<double, 3> height;
    for (int k = 0; k < 3; ++k) {
        local[k] = {corners[k].x() - x, corners[k].y() - y, corners[k].z()};
        root[k] = std::sqrt(std::max(
            radius * radius - (local[k].x() * local[k].x() + local[k].y() * local[k].y()),
            0.0));
        height[k] = local[k].z() + root[k];
    }
    const int other = height[1] > height[2] ? 1 : 2;
    const int highest = height[0] > height[other] ? 0 : other;
    if (!(root[highest] > least_root * radius))
        return std::nullopt;
    const Vec3& from = local[highest];
    double rise = 0;  // from there to another corner, drawn out, times the root
    for (int k = 1; k < 3; ++k) {
        const Vec3 side = local[(highest + k) % 3] - from;
        rise = std::max(
            rise, side.z() * root[highest] - (from.x() * side.x() + from.y() * side.y()));
    }
    const double tip = from.z() - (radius - root[highest]);
    return HighestCorner{highest, tip, rise > 0 ? tip + rise / root[highest] : tip};
}

}  // namespace endmill
