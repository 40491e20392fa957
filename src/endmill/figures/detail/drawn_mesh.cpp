// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/drawn_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <numeric>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/mesh/decimation.h"

namespace endmill {
namespace {

// Decimation takes some ten microseconds a triangle. A mesh of more than this multiple of
// the triangles wanted is made coarser by a grid first.
constexpr std::size_t decimated_share = 2;
// Cells along the longest side of the part. The finest cell is about one pixel of a
// picture, the coarsest still shows the shape.
constexpr std::array<int, 8> grids{512, 256, 128, 96, 64, 48, 32, 16};

// For each point, the point of the lowest number in its cell.
std::vector<std::int32_t> representatives(std::span<const Vec3> points, int grid)
{
    Eigen::AlignedBox3d box;
    for (const Vec3& point : points)
        box.extend(point);
    const double side = box.sizes().maxCoeff();
    const double per_mm = side > 0 ? grid / side : 0;
    const auto cell = [&](std::int32_t number) {
        const Vec3 place = per_mm * (points[number] - box.min());
        const auto at = [&](int axis) { return static_cast<std::int64_t>(place[axis]); };
        return (at(0) * (grid + 1) + at(1)) * (grid + 1) + at(2);
    };
    std::vector<std::pair<std::int64_t, std::int32_t>> by_cell;
    by_cell.reserve(points.size());
    for (std::int32_t k = 0; k < std::ssize(points); ++k)
        by_cell.emplace_back(cell(k), k);
    std::ranges::sort(by_cell);
    std::vector<std::int32_t> firsts(points.size());
    std::int32_t first = 0;
    for (std::size_t k = 0; k < by_cell.size(); ++k) {
        if (k == 0 || by_cell[k].first != by_cell[k - 1].first)
            first = by_cell[k].second;
        firsts[by_cell[k].second] = first;
    }
    return firsts;
}

// The same triangle with its lowest corner first.
Triangle from_least(const Triangle& triangle)
{
    Triangle turned = triangle;
    std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()),
                turned.end());
    return turned;
}

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

DrawnMesh all_of(std::span<const Triangle> triangles)
{
    DrawnMesh drawn{{triangles.begin(), triangles.end()},
                    std::vector<std::size_t>(triangles.size())};
    std::iota(drawn.facets.begin(), drawn.facets.end(), std::size_t{0});
    return drawn;
}

// The finest mesh that a grid makes of the triangles and that has at most `most` of them;
// all of them if every grid either leaves more or leaves none, as where the part is
// scattered in pieces smaller than a cell.
DrawnMesh merged_in_grid(std::span<const Vec3> points,
                         std::span<const Triangle> triangles, std::size_t most)
{
    for (const int grid : grids) {
        DrawnMesh drawn = coarser(points, triangles, grid);
        if (!drawn.triangles.empty() && drawn.triangles.size() <= most)
            return drawn;
    }
    return all_of(triangles);
}

// The decimated triangles, by the numbers of the given points and facets.
DrawnMesh decimated_to(std::span<const Vec3> points, const DrawnMesh& given,
                       std::size_t most)
{
    const DecimatedMesh coarse =
        decimated({{points.begin(), points.end()}, given.triangles}, most);
    DrawnMesh drawn;
    for (const auto& [a, b, c] : coarse.mesh.triangles())
        drawn.triangles.push_back(
            {coarse.source_points[a], coarse.source_points[b], coarse.source_points[c]});
    for (const std::int32_t triangle : coarse.source_triangles)
        drawn.facets.push_back(given.facets[triangle]);
    return drawn;
}

// At most `most` of the triangles, at equal steps of their numbers.
DrawnMesh thinned(const DrawnMesh& given, std::size_t most)
{
    const std::size_t step = (given.triangles.size() + most - 1) / most;
    DrawnMesh drawn;
    for (std::size_t k = 0; k < given.triangles.size(); k += step) {
        drawn.triangles.push_back(given.triangles[k]);
        drawn.facets.push_back(given.facets[k]);
    }
    return drawn;
}

}  // namespace

DrawnMesh drawn_mesh(std::span<const Vec3> points, std::span<const Triangle> triangles,
                     std::size_t most)
{
    require(most > 0, "drawn_mesh: need room for a triangle");
    if (triangles.size() <= most)
        return all_of(triangles);
    DrawnMesh drawn = triangles.size() > decimated_share * most
                          ? merged_in_grid(points, triangles, decimated_share * most)
                          : all_of(triangles);
    if (drawn.triangles.size() <= decimated_share * most)
        drawn = decimated_to(points, drawn, most);
    return drawn.triangles.size() <= most ? drawn : thinned(drawn, most);
}

}  // namespace endmill
