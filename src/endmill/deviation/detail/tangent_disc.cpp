// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/tangent_disc.h"

#include <Eigen/Geometry>

namespace endmill {

TangentDisc tangent_disc(std::span<const Vec3, 4> corners)
{
    TangentDisc disc;
    disc.centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    const Vec3 across = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    if (const double size = across.norm(); size > 0)
        disc.normal = across / size;
    return disc;
}

}  // namespace endmill
