// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/deviation/detail/half_space.h"

namespace endmill {

/// What holds rays that lie near each other: their points a cylinder, their directions a
/// cone.
struct RayBundle {
    Vec3 centre;         ///< of the points, mm
    Vec3 upright;        ///< along the mean of the directions, unit
    double beside = 0;   ///< mm, of the furthest point across the mean
    double above = 0;    ///< mm, along it, up or down
    double tilt = 0;     ///< greatest length of a direction less the mean
    double longest = 0;  ///< mm, of the rays

    /// Whether no ray, `length` mm long, comes within `margin` mm of the half space.
    bool is_out_of_reach(const HalfSpace& half, double margin, double length) const
    {
        const double along = half.normal.dot(upright);
        const double across = (half.normal - along * upright).norm();
        const double most = beside * across + above * std::abs(along) +
                            length * std::max(0.0, along + tilt) + margin;
        return half.least - half.normal.dot(centre) >= most;
    }
};

/// What holds the rays of all `bundles`.
/// \pre there is one.
RayBundle common_bundle(std::span<const RayBundle> bundles);

/// `direction` as a unit vector; +z if it is zero.
inline Vec3 unit_or_up(const Vec3& direction)
{
    const double size = direction.norm();
    return size > 0 ? Vec3{direction / size} : Vec3::UnitZ();
}

}  // namespace endmill
