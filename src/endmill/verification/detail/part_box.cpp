// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/verification/detail/part_box.h"

#include <limits>

#include "endmill/surface/extent.h"

namespace endmill {

Block bounding_box(const Part& part)
{
    Block box{Vec3::Constant(std::numeric_limits<double>::infinity()),
              Vec3::Constant(-std::numeric_limits<double>::infinity())};
    if (const auto* mesh = std::get_if<TriangleMesh>(&part)) {
        for (const Triangle& triangle : mesh->triangles())
            for (const std::int32_t corner : triangle) {
                const Vec3& point = mesh->points()[static_cast<std::size_t>(corner)];
                box.low = box.low.cwiseMin(point);
                box.high = box.high.cwiseMax(point);
            }
        return box;
    }
    for (int c = 0; c < 3; ++c) {
        const Interval along =
            extent(std::get<std::vector<Surface>>(part), Vec3::Unit(c));
        box.low[c] = along.low;
        box.high[c] = along.high;
    }
    return box;
}

}  // namespace endmill
