// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/place_order.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <numeric>
#include <span>

namespace endmill {
namespace {

// Triangles by which their points are fetched in advance.
constexpr std::size_t triangles_ahead = 12;

// A grid of cubic cells over the bounding box of points.
class CellGrid {
public:
    explicit CellGrid(std::span<const Vec3> points)
    {
        Vec3 high = low_ = points.front();
        for (const Vec3& point : points) {
            low_ = low_.cwiseMin(point);
            high = high.cwiseMax(point);
        }
        // halves, so that the size is finite
        const Vec3 half = high / 2 - low_ / 2;
        const double longest = half.maxCoeff();
        const Vec3 shares = longest > 0 ? Vec3{half / longest} : Vec3{Vec3::Zero()};
        // As many cells along the longest side as the total allows.
        for (int along = most_cells; cells() > most_cells; along = along * 7 / 8)
            for (int axis = 0; axis < 3; ++axis)
                counts_[axis] = 1 + static_cast<int>(shares[axis] * (along - 1));
        for (int axis = 0; axis < 3; ++axis)
            cells_per_mm_[axis] = half[axis] > 0 ? counts_[axis] / half[axis] / 2 : 0;
    }

    std::size_t cells() const
    {
        return std::size_t(counts_[0]) * counts_[1] * counts_[2];
    }

    // The cell of a point.
    std::uint16_t cell_of(const Vec3& point) const
    {
        int cell = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const double along = (point[axis] - low_[axis]) * cells_per_mm_[axis];
            // also if the product overflows or is not a number
            const int number =
                along < counts_[axis] ? static_cast<int>(along) : counts_[axis] - 1;
            cell = cell * counts_[axis] + number;
        }
        return static_cast<std::uint16_t>(cell);
    }

private:
    // Few enough for the counters of a counting sort to stay in the nearest cache.
    static constexpr int most_cells = 4096;

    Vec3 low_;
    std::array<int, 3> counts_{most_cells, most_cells, most_cells};
    std::array<double, 3> cells_per_mm_{};
};

// The numbers of the triangles, by the cells of their first corners.
std::vector<std::int32_t> order_by_cell(const TriangleMesh& mesh)
{
    const CellGrid grid{mesh.points()};
    const std::span<const Triangle> triangles = mesh.triangles();
    std::vector<std::uint16_t> cells(triangles.size());
    std::vector<std::size_t> end(grid.cells());
    for (std::size_t k = 0; k < triangles.size(); ++k) {
        mesh.prefetch_corners(k + triangles_ahead);
        cells[k] = grid.cell_of(mesh.points()[triangles[k][0]]);
        ++end[cells[k]];
    }
    std::inclusive_scan(end.begin(), end.end(), end.begin());
    std::vector<std::int32_t> order(triangles.size());
    for (std::size_t k = triangles.size(); k-- > 0;)
        order[--end[cells[k]]] = static_cast<std::int32_t>(k);
    return order;
}

}  // namespace

bool are_scattered(const TriangleMesh& mesh)
{
    constexpr std::size_t samples = 1024;
    // Points of this many numbers fill a cache of a megabyte, the second of common
    // machines, with what is known of them.
    constexpr std::size_t near = 1U << 15U;
    const std::span<const Triangle> triangles = mesh.triangles();
    if (mesh.points().size() < 4 * near || triangles.size() < 4 * near)
        return false;
    const std::size_t step = triangles.size() / samples;
    double jumps = 0;
    for (std::size_t k = step; k < triangles.size(); k += step)
        jumps += std::abs(double(triangles[k][0]) - double(triangles[k - 1][0]));
    return jumps > double(near * samples);
}

TrianglesByPlace triangles_by_place(const TriangleMesh& mesh)
{
    constexpr std::int32_t none = -1;
    if (mesh.triangles().empty())
        return {};
    const std::vector<std::int32_t> order = order_by_cell(mesh);
    std::vector<std::int32_t> new_number(mesh.points().size(), none);
    TrianglesByPlace result;
    result.triangles.resize(order.size());
    result.points.reserve(mesh.points().size());
    for (std::size_t k = 0; k < order.size(); ++k) {
        const std::size_t ahead = std::min(k + triangles_ahead, order.size() - 1);
        __builtin_prefetch(&mesh.triangles()[order[ahead]]);
        for (int corner = 0; corner < 3; ++corner) {
            const std::int32_t point = mesh.triangles()[order[k]][corner];
            if (new_number[point] == none) {
                new_number[point] = static_cast<std::int32_t>(result.points.size());
                result.points.push_back(point);
            }
            result.triangles[k][corner] = new_number[point];
        }
    }
    return result;
}

}  // namespace endmill
