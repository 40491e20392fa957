// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/view_frame.h"

#include <cstdint>
#include <vector>

namespace endmill {

void ViewBox::add(const Vec3& point)
{
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
}

Vec3 ViewBox::centre() const
{
    return low.x() <= high.x() ? Vec3{(low + high) / 2} : Vec3{Vec3::Zero()};
}

double ViewBox::size() const
{
    return low.x() <= high.x() ? (high - low).norm() : 0;
}

Json array_json(const PageArray& array)
{
    return {{"array", array.kind}, {"offset", array.offset}, {"length", array.length}};
}

Json mesh_json(ViewFrame& frame, const TriangleMesh& mesh, const Vec3& origin)
{
    std::vector<float> points;
    points.reserve(3 * mesh.points().size());
    for (const Vec3& point : mesh.points())
        for (int c = 0; c < 3; ++c)
            points.push_back(static_cast<float>(point[c] - origin[c]));
    std::vector<std::uint32_t> triangles;
    triangles.reserve(3 * mesh.triangles().size());
    for (const Triangle& triangle : mesh.triangles())
        for (const std::int32_t corner : triangle)
            triangles.push_back(static_cast<std::uint32_t>(corner));
    return {{"points", array_json(frame.numbers.add(points))},
            {"triangles", array_json(frame.numbers.add(triangles))}};
}

}  // namespace endmill
