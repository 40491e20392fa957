// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ray_bounds.h"

namespace endmill {

RayBounds common_bounds(std::span<const RayBounds> bounds)
{
    RayBounds common{Vec3::Zero(), Vec3::Zero()};
    for (const RayBounds& one : bounds) {
        common.centre += one.centre / double(bounds.size());
        common.upright += one.upright / double(bounds.size());
    }
    common.upright = unit_or_up(common.upright);
    for (const RayBounds& one : bounds) {
        // In any direction, no point is further from its own centre than this.
        const double around = std::hypot(one.beside, one.above);
        const Vec3 away = one.centre - common.centre;
        const double along = away.dot(common.upright);
        common.above = std::max(common.above, std::abs(along) + around);
        common.beside =
            std::max(common.beside, (away - along * common.upright).norm() + around);
        common.tilt =
            std::max(common.tilt, (one.upright - common.upright).norm() + one.tilt);
        common.longest = std::max(common.longest, one.longest);
    }
    return common;
}

}  // namespace endmill
