// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/offset/detail/grid_sides.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace endmill {
namespace {

// A key by which sides with the same end points become neighbours when sorted: the
// component of the sum of both ends in a direction to which sides are rarely
// perpendicular.
double middle_of_ends(const GridSide& side)
{
    return (side.points.front() + side.points.back()).dot(Vec3{0.742, 0.518, 0.425});
}

GridSide side_of(const Surface& surface, const OffsetGrid& grid, int number,
                 double same_point)
{
    GridSide side;
    const auto places = grid.side_places(number);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const auto [i, j] = places[k];
        const auto [from_i, from_j] = places[k > 0 ? k - 1 : k];
        const auto [to_i, to_j] = places[k + 1 < places.size() ? k + 1 : k];
        const SurfaceTangents at = tangents_at(grid, surface, i, j);
        side.vertices.push_back(grid.vertex(i, j));
        side.points.push_back(at.point);
        const auto sign = [](std::int32_t step) { return (step > 0) - (step < 0); };
        side.along.push_back(sign(to_i - from_i) * at.du + sign(to_j - from_j) * at.dv);
    }
    side.is_collapsed = std::ranges::all_of(side.points, [&](const Vec3& point) {
        return (point - side.points.front()).norm() <= same_point;
    });
    // Where the partial derivative vanishes, the neighbouring points give the direction.
    for (std::size_t k = 0; k < side.points.size(); ++k)
        if (side.along[k].norm() <= same_point)
            side.along[k] = side.points[std::min(k + 1, side.points.size() - 1)] -
                            side.points[k > 0 ? k - 1 : 0];
    return side;
}

bool are_mates(const GridSide& one, const GridSide& two, double same_point)
{
    const std::size_t count = one.points.size();
    if (two.points.size() != count)
        return false;
    for (std::size_t k = 0; k < count; ++k)
        if ((one.points[k] - two.points[count - 1 - k]).norm() > same_point)
            return false;
    return true;
}

void find_mates(std::vector<GridSide>& sides, double same_point)
{
    std::vector<std::int32_t> order(sides.size());
    std::iota(order.begin(), order.end(), 0);
    std::erase_if(order, [&](std::int32_t k) { return sides[k].is_collapsed; });
    std::ranges::stable_sort(order, {},
                             [&](std::int32_t k) { return middle_of_ends(sides[k]); });
    for (auto one = order.begin(); one != order.end(); ++one)
        for (auto two = one + 1;
             two != order.end() && sides[*one].mate == GridSide::none &&
             middle_of_ends(sides[*two]) <= middle_of_ends(sides[*one]) + 4 * same_point;
             ++two)
            if (sides[*two].mate == GridSide::none &&
                are_mates(sides[*one], sides[*two], same_point)) {
                sides[*one].mate = *two;
                sides[*two].mate = *one;
            }
}

}  // namespace

std::vector<GridSide> grid_sides(std::span<const Surface> surfaces,
                                 std::span<const OffsetGrid> grids, double same_point)
{
    std::vector<GridSide> sides;
    for (const OffsetGrid& grid : grids)
        for (int number = 0; number < 4; ++number)
            sides.push_back(side_of(surfaces[grid.surface], grid, number, same_point));
    find_mates(sides, same_point);
    return sides;
}

std::int32_t next_side(std::int32_t number)
{
    return number / 4 * 4 + (number + 1) % 4;
}

std::int32_t previous_side(std::int32_t number)
{
    return number / 4 * 4 + (number + 3) % 4;
}

}  // namespace endmill
