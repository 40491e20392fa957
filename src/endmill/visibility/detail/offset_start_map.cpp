// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/offset_start_map.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "endmill/core/tolerance.h"
#include "endmill/mesh/triangle_tree.h"

namespace endmill {
namespace {

double largest_distance(const TriangleMesh& mesh)
{
    double largest = 0;
    for (const Vec3& point : mesh.points())
        largest = std::max(largest, point.norm());
    return largest;
}

}  // namespace

VisibilityMap offset_start_map(const TriangleMesh& mesh, std::span<const Vec3> directions,
                               Angle incidence, double start)
{
    const TriangleTree tree{mesh};
    const double offset = start * largest_distance(mesh);
    const double cosine = std::max(std::cos(incidence.radians()), least_facing_cosine);
    VisibilityMap map{mesh.triangles().size(), directions.size()};
    for (std::size_t j = 0; j < map.facets(); ++j) {
        const auto [a, b, c] = mesh.corners(j);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        const Vec3 origin = (a + b + c) / 3 + offset * normal;
        for (std::size_t cell = 0; cell < directions.size(); ++cell) {
            const Vec3& direction = directions[cell];
            if (normal.dot(direction) > cosine && !tree.any_hit({origin, direction}))
                map.column(cell)[j / 64] |= std::uint64_t{1} << (j % 64);
        }
    }
    return map;
}

}  // namespace endmill
