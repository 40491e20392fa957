// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/ray_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/deviation/detail/half_space.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
using Row = RayRows::Row;
using Lanes = std::array<double, RayRows::lanes>;

// Computes the distances that `shortfalls` returns, and the smallest of them. The entries
// beyond the rays are copies of a ray that is shorter, so they are not smaller.
ENDMILL_WIDEST_REGISTERS
double fall_short(const RayRows& rows, const HalfSpace& half, double margin, double spare,
                  double* __restrict short_by)
{
    const double x = half.normal.x();
    const double y = half.normal.y();
    const double z = half.normal.z();
    const double least = half.least;
    Lanes smallest;
    smallest.fill(infinite);
    for (int first = 0; first < rows.padded(); first += RayRows::lanes) {
        ENDMILL_NOT_UNROLLED
        for (int lane = 0; lane < RayRows::lanes; ++lane) {
            const int k = first + lane;
            const double at =
                x * rows.point[0][k] + y * rows.point[1][k] + z * rows.point[2][k];
            const double rate =
                x * rows.normal[0][k] + y * rows.normal[1][k] + z * rows.normal[2][k];
            const double length = rows.left[k] + margin;
            const double way = select(length > 0, length, 0) * select(rate > 0, rate, 0);
            const double gap = least - margin - at - way + spare;
            short_by[k] = gap;
            smallest[lane] = select(gap < smallest[lane], gap, smallest[lane]);
        }
    }
    return std::ranges::min(smallest);
}

}  // namespace

ENDMILL_WIDEST_REGISTERS
double greatest(const Row& row, int count)
{
    Lanes most{};
    for (int first = 0; first < count; first += RayRows::lanes) {
        ENDMILL_NOT_UNROLLED
        for (int lane = 0; lane < RayRows::lanes; ++lane)
            most[lane] =
                select(row[first + lane] > most[lane], row[first + lane], most[lane]);
    }
    return std::ranges::max(most);
}

double shortfalls(const RayRows& rows, const HalfSpace& half, double margin, double spare,
                  Row& short_by)
{
    return fall_short(rows, half, margin, spare, short_by.data());
}

double longest_left(const RayRows& rows)
{
    return greatest(rows.left, rows.count);
}

}  // namespace endmill
