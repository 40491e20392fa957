// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tangent_disc.h"

#include <Eigen/Geometry>

namespace endmill {

Slab middle_of(std::span<const Vec3, 4> corners)
{
    Slab slab;
    slab.centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    const Vec3 across = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    if (const double size = across.norm(); size > 0)
        slab.normal = across / size;
    return slab;
}

}  // namespace endmill
