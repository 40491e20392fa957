// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/surface_cells.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string_view>

#include <Eigen/Geometry>

namespace endmill {
namespace {

// The point that divides an interval in the ratio number : count - number.
double part_of(const Interval& interval, int number, int count)
{
    const double t = static_cast<double>(number) / count;
    return (1 - t) * interval.low + t * interval.high;
}

// The parameter interval of column or row `number`, counted through all patches.
Interval sub_interval(std::span<const double> breaks, int number, int spaces)
{
    const auto patch = static_cast<std::size_t>(number / spaces);
    const Interval whole{breaks[patch], breaks[patch + 1]};
    return {part_of(whole, number % spaces, spaces),
            part_of(whole, number % spaces + 1, spaces)};
}

// The cell in a column and row. Points are evaluated in the cell's own patch, since
// neighbouring patches need not join smoothly.
SurfaceCell cell(const Surface& surface, int column, int row, int spaces)
{
    const Interval u = sub_interval(surface.breaks(Parameter::U), column, spaces);
    const Interval v = sub_interval(surface.breaks(Parameter::V), row, spaces);
    const int i = column / spaces;
    const int j = row / spaces;
    SurfaceCell cell;
    for (int k = 0; k < SurfaceCell::steps_per_side; ++k) {
        const double rising_u = part_of(u, k, SurfaceCell::steps_per_side);
        const double rising_v = part_of(v, k, SurfaceCell::steps_per_side);
        const double falling_u =
            part_of(u, SurfaceCell::steps_per_side - k, SurfaceCell::steps_per_side);
        const double falling_v =
            part_of(v, SurfaceCell::steps_per_side - k, SurfaceCell::steps_per_side);
        cell.outline[k] = surface.jet_in_patch(i, j, rising_u, v.low).point;
        cell.outline[k + SurfaceCell::steps_per_side] =
            surface.jet_in_patch(i, j, u.high, rising_v).point;
        cell.outline[k + 2 * SurfaceCell::steps_per_side] =
            surface.jet_in_patch(i, j, falling_u, v.high).point;
        cell.outline[k + 3 * SurfaceCell::steps_per_side] =
            surface.jet_in_patch(i, j, u.low, falling_v).point;
    }
    cell.is_border = {row % spaces == 0, (column + 1) % spaces == 0,
                      (row + 1) % spaces == 0, column % spaces == 0};
    return cell;
}

}  // namespace

std::vector<SurfaceCell> surface_cells(const Surface& surface, int spaces)
{
    std::vector<SurfaceCell> cells;
    for (int row = 0; row < spaces * surface.patches(Parameter::V); ++row)
        for (int column = 0; column < spaces * surface.patches(Parameter::U); ++column)
            cells.push_back(cell(surface, column, row, spaces));
    return cells;
}

std::string shade_of(const Vec3& normal, const AxonometricView& view)
{
    constexpr std::array<int, 3> darkest{166, 186, 212};
    constexpr std::array<int, 3> lightest{240, 246, 252};
    const Vec3 light = (view.toward + 0.5 * view.up - 0.6 * view.right).normalized();
    const double size = normal.norm();
    const double facing = size > 0 ? std::abs(normal.dot(light)) / size : 1;
    constexpr std::string_view digits = "0123456789abcdef";
    std::string colour = "#";
    for (std::size_t c = 0; c < 3; ++c) {
        const auto value =
            static_cast<unsigned>(darkest[c] + (lightest[c] - darkest[c]) * facing);
        colour += digits[value / 16];
        colour += digits[value % 16];
    }
    return colour;
}

std::string shade_of(const SurfaceCell& cell, const AxonometricView& view)
{
    return shade_of(cell.diagonals_normal(), view);
}

}  // namespace endmill
