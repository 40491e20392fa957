// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ray_bundle.h"

namespace endmill {

RayBundle common_bundle(std::span<const RayBundle> bundles)
{
    RayBundle common{Vec3::Zero(), Vec3::Zero()};
    for (const RayBundle& bundle : bundles) {
        common.centre += bundle.centre / double(bundles.size());
        common.upright += bundle.upright / double(bundles.size());
    }
    common.upright = unit_or_up(common.upright);
    for (const RayBundle& bundle : bundles) {
        // No point is further from its own centre, in any direction.
        const double around = std::hypot(bundle.beside, bundle.above);
        const Vec3 away = bundle.centre - common.centre;
        const double along = away.dot(common.upright);
        common.above = std::max(common.above, std::abs(along) + around);
        common.beside =
            std::max(common.beside, (away - along * common.upright).norm() + around);
        common.tilt =
            std::max(common.tilt, (bundle.upright - common.upright).norm() + bundle.tilt);
        common.longest = std::max(common.longest, bundle.longest);
    }
    return common;
}

}  // namespace endmill
