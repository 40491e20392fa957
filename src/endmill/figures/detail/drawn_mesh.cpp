// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/drawn_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

// Vertex clustering: a grid of cubes is laid over the part, all points in a cube are
// replaced by the first of them, and triangles that lose a corner or become equal are
// dropped. It keeps the shape within the size of a cube, works for every mesh, and takes
// linear time up to a sort. The kept points are points of the mesh, so no new coordinates
// arise.

namespace endmill {
namespace {

// Numbers of cubes along the longest side, from about one cube per px to a coarse shape.
constexpr std::array<int, 8> grids{512, 256, 128, 96, 64, 48, 32, 16};

// For each point the index of the first point in its cube.
std::vector<std::int32_t> representatives(std::span<const Vec3> points, int grid)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    const double side = box.sizes().maxCoeff();
    const double per_mm = side > 0 ? grid / side : 0;
    const auto cube = [&](std::int32_t number) {
        const Vec3 place = per_mm * (points[number] - box.min());
        const auto at = [&](int axis) { return static_cast<std::int64_t>(place[axis]); };
        return (at(0) * (grid + 1) + at(1)) * (grid + 1) + at(2);
    };
    std::vector<std::pair<std::int64_t, std::int32_t>> by_cube;
    by_cube.reserve(points.size());
    for (std::int32_t k = 0; k < std::ssize(points); ++k)
        by_cube.emplace_back(cube(k), k);
    std::ranges::sort(by_cube);
    std::vector<std::int32_t> firsts(points.size());
    std::int32_t first = 0;
    for (std::size_t k = 0; k < by_cube.size(); ++k) {
        if (k == 0 || by_cube[k].first != by_cube[k - 1].first)
            first = by_cube[k].second;
        firsts[by_cube[k].second] = first;
    }
    return firsts;
}

// The triangle with its least index first; the orientation is kept.
Triangle from_least(const Triangle& triangle)
{
    Triangle turned = triangle;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()),
                turned.end());
    return turned;
}

// The mesh after clustering its points in the cubes of a grid.
DrawnMesh coarser(std::span<const Vec3> points, std::span<const Triangle> triangles,
                  int grid)
{
    const std::vector<std::int32_t> firsts = representatives(points, grid);
    std::vector<std::pair<Triangle, std::size_t>> kept;
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        const auto& [a, b, c] = triangles[k];
        const Triangle moved{firsts[a], firsts[b], firsts[c]};
        if (moved[0] != moved[1] && moved[1] != moved[2] && moved[2] != moved[0])
            kept.emplace_back(from_least(moved), k);
    }
    std::ranges::sort(kept);
    DrawnMesh drawn;
    for (std::size_t k = 0; k < kept.size(); ++k) {
        if (k > 0 && kept[k].first == kept[k - 1].first)
            continue;
        drawn.triangles.push_back(kept[k].first);
        drawn.facets.push_back(kept[k].second);
    }
    return drawn;
}

// Every `step`-th triangle.
DrawnMesh every(std::span<const Triangle> triangles, std::size_t step)
{
    DrawnMesh drawn;
    for (std::size_t k = 0; k < triangles.size(); k += step) {
        drawn.triangles.push_back(triangles[k]);
        drawn.facets.push_back(k);
    }
    return drawn;
}

}  // namespace

// Coarser grids are tried until the mesh is small enough.
DrawnMesh drawn_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     std::size_t most)
{
    require(most > 0, "drawn_mesh: need room for a triangle");
    if (triangles.size() <= most)
        return every(triangles, 1);
    for (const int grid : grids) {
        DrawnMesh drawn = coarser(points, triangles, grid);
        // A part that is smaller than a cube would vanish; finer or no clustering is used
        // then.
        if (!drawn.triangles.empty() && drawn.triangles.size() <= most)
            return drawn;
    }
    return every(triangles, (triangles.size() + most - 1) / most);
}

}  // namespace endmill
