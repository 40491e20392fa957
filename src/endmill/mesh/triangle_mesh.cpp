// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/triangle_mesh.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "endmill/core/error.h"

namespace endmill {

TriangleMesh::TriangleMesh(std::vector<Vec3> points, std::vector<Triangle> triangles)
    : points_{std::move(points)},
      triangles_{std::move(triangles)}
{
    constexpr std::size_t most = std::numeric_limits<std::int32_t>::max();
    require(points_.size() <= most && triangles_.size() <= most,
            "TriangleMesh: at most 2^31 - 1 points and triangles");
    require(
        std::ranges::all_of(points_, [](const Vec3& point) { return point.allFinite(); }),
        "TriangleMesh: points must be finite");
    const auto count = static_cast<std::int32_t>(points_.size());
    const auto exists = [&](std::int32_t number) {
        return 0 <= number && number < count;
    };
    require(std::ranges::all_of(triangles_,
                                [&](const Triangle& corners) {
                                    return std::ranges::all_of(corners, exists);
                                }),
            "TriangleMesh: a triangle names a point that does not exist");
}

}  // namespace endmill
