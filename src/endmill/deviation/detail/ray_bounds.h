// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/deviation/detail/half_space.h"

namespace endmill {

/// Bounding volumes of neighbouring rays: a cylinder around their points and a cone
/// around their directions.
struct RayBounds {
    Vec3 centre;        ///< mean of the points, mm
    Vec3 upright;       ///< mean of the directions, unit: axis of cylinder and cone
    double beside = 0;  ///< greatest distance of a point from the axis, mm
    /// Greatest distance of a point from the centre along the axis, mm.
    double above = 0;
    double tilt = 0;  ///< greatest length of the difference of a direction and `upright`
    double longest = 0;  ///< length of the longest ray, mm

    /// Whether no ray of at most `length` mm comes within `margin` mm of the half space.
    bool is_out_of_reach(const HalfSpace& half, double margin, double length) const
    {
        const double along = half.normal.dot(upright);
        const double across = (half.normal - along * upright).norm();
        const double most = beside * across + above * std::abs(along) +
                            length * std::max(0.0, along + tilt) + margin;
        return half.least - half.normal.dot(centre) >= most;
    }
};

/// Returns bounds of the rays of all `bounds`.
/// \pre `bounds` is not empty.
RayBounds common_bounds(std::span<const RayBounds> bounds);

/// Returns `direction` as a unit vector; +z if it is zero.
inline Vec3 unit_or_up(const Vec3& direction)
{
    const double size = direction.norm();
    return size > 0 ? Vec3{direction / size} : Vec3::UnitZ();
}

}  // namespace endmill
