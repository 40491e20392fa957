// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/bull_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "endmill/core/detail/widest_registers.h"

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Keeps a slope to divide by a number.
constexpr double least_slope = 1e-200;  // mm^2
// Of the sine sought: the next step, were it taken, would be about its square.
constexpr double step_share = 1e-7;
// Steps from above the root of a convex function: some five on a short move, sixty where the
// slope is next to nothing.
constexpr int most_iterations = 200;

using Lanes = std::array<double, side>;

inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

inline double larger(double a, double b)
{
    return a > b ? a : b;
}

// A flat bottom of radius c with a corner of radius r around it.
struct Shape {
    double R;
    double r;
    double c;
};

// S under a bull-nose cutter that stays level, or does not move.
ENDMILL_WIDEST_REGISTERS
void level_bull_heights(const TilePlace& place, const SweptMove& move, const Shape& shape,
                        TileHeights& heights)
{
    const double r = shape.r;
    const double length = move.length;
    const double z = move.z;
    for (int j = 0; j < side; ++j) {
        const TileRow row = tile_row(place, j, move, shape.R);
        for (int i = 0; i < side; ++i) {
            const double s = row.s[i];
            const double e = row.e[i];
            const double rest = s - length;
            const double beyond = select(rest > 0, rest, 0);
            const double t = select(s < 0, s, beyond);
            const double distance = std::sqrt(e * e + t * t);
            const double out = distance - shape.c;
            const double a = select(out > 0, out, 0);
            const double root = std::sqrt(std::abs((r - a) * (r + a)));
            const double swept = z + (r - root);
            heights[j * side + i] = select(distance <= shape.R, swept, infinite);
        }
    }
}

// The heights under the end of the move, infinite where it is out of reach; and for which
// cells, with a number below 0 in `open`, the cutter may have been lower, and lower than
// `tile`, between the ends.
ENDMILL_WIDEST_REGISTERS
void look_from_end(const double* __restrict tile, const TilePlace& place,
                   const SweptMove& move, Shape shape, double* __restrict heights,
                   double* __restrict open)
{
    const double m = move.slope;
    const double length = move.length;
    const double z = move.z + move.rise;
    // A cell that the cutter has left is near its rim on all the way.
    const double near_rim = larger(shape.r - length, 0);
    const double lowest = smaller(move.z, z) + shape.r -
                          std::sqrt((shape.r - near_rim) * (shape.r + near_rim));
    for (int j = 0; j < side; ++j) {
        const TileRow row = tile_row(place, j, move, shape.R);
        for (int i = 0; i < side; ++i) {
            const int k = j * side + i;
            const double t = row.s[i] - length;
            const double e = row.e[i];
            const double distance = std::sqrt(e * e + t * t);
            const double out = distance - shape.c;
            const double a = select(out > 0, out, 0);
            const double root = std::sqrt(std::abs((shape.r - a) * (shape.r + a)));
            const double under = z + (shape.r - root);
            // The tangent to the height over the way, from the end on backwards.
            const double steep = root * distance;
            const double rise = m * steep - a * t;
            const double above = (under - tile[k]) * steep - rise * length;
            const double tangent = select(rise > 0, above, 1);
            const double missed =
                larger(larger(t, -row.s[i] - shape.R), lowest - tile[k]);
            const double left = select(row.q[i] >= 0, missed, 1);
            heights[k] = select(distance <= shape.R, under, infinite);
            open[k] = select(distance <= shape.R, tangent, left);
        }
    }
}

// Leaves open only the cells over which the cutter sinks as the move begins: over the others
// it was lowest there. The comparison of m with profile'(d) t / d, without its roots.
ENDMILL_WIDEST_REGISTERS
void look_from_start(const TilePlace& place, const SweptMove& move, Shape shape,
                     double* __restrict open)
{
    const double slope2 = move.slope * std::abs(move.slope);
    for (int j = 0; j < side; ++j) {
        const TileRow row = tile_row(place, j, move, shape.R);
        for (int i = 0; i < side; ++i) {
            const double s = row.s[i];
            const double e = row.e[i];
            const double distance2 = e * e + s * s;
            const double out = std::sqrt(distance2) - shape.c;
            const double a = select(out > 0, out, 0);
            const double cosine2 = (shape.r - a) * (shape.r + a);
            const double root2 = select(cosine2 > 0, cosine2, 0);
            const double climb = slope2 * root2 * distance2 - a * a * (s * std::abs(s));
            open[j * side + i] = larger(open[j * side + i], climb);
        }
    }
}

// Cells that the cutter passes between the ends of its move.
struct Passed {
    Lanes s;  // along the move from its start
    Lanes e;  // across it
    // From the cell to the cutter's axis on the side where the cutter is lower, and the
    // sine of the corner's angle over the cell there.
    Lanes t_low;
    Lanes t_high;
    Lanes low;
    Lanes high;
    Lanes sine;
};

// The part of the move on which the cutter is over each cell; the sine begins in its middle.
ENDMILL_WIDEST_REGISTERS
void bracket(Passed& cells, double length, double lower_side, const Shape& shape)
{
    for (int i = 0; i < side; ++i) {
        const double s = cells.s[i];
        const double e = std::abs(cells.e[i]);
        const double q = (shape.R - e) * (shape.R + e);
        const double w = std::sqrt(select(q > 0, q, 0));
        const double from = larger(s - w, 0);
        const double to = smaller(s + w, length);
        const double first = select(lower_side > 0, from - s, s - to);
        const double last = select(lower_side > 0, to - s, s - from);
        const double t_low = larger(first, 0);
        const double t_high = larger(last, t_low);
        const double low = (std::sqrt(e * e + t_low * t_low) - shape.c) / shape.r;
        const double high = (std::sqrt(e * e + t_high * t_high) - shape.c) / shape.r;
        cells.t_low[i] = t_low;
        cells.t_high[i] = t_high;
        cells.low[i] = smaller(larger(low, 0), 1);
        cells.high[i] = smaller(larger(high, 0), 1);
        cells.sine[i] = cells.low[i] + (cells.high[i] - cells.low[i]) / 2;
    }
}

// One step of Newton's iteration for the sine x: the cutter is lowest over the cell where
// x t = m sqrt(1 - x^2) d, with d = c + r x, t^2 = d^2 - e^2. The difference of the squares
// is a convex function of x from its root on.
// Source: spec of the removal, section 1, profile'(d) t / d = m, in the corner's angle.
// \return the longest step, as a share of the sine
ENDMILL_WIDEST_REGISTERS
double improve(Passed& cells, double m, const Shape& shape)
{
    const double m2 = m * m;
    Lanes steps;
    for (int i = 0; i < side; ++i) {
        const double x = cells.sine[i];
        const double e = std::abs(cells.e[i]);
        const double d = shape.c + shape.r * x;
        const double t2 = (d - e) * (d + e);
        const double cosine2 = (1 - x) * (1 + x);
        const double value = x * x * t2 - m2 * d * d * cosine2;
        const double rise =
            2 * (x * t2 + shape.r * d * (x * x - m2 * cosine2) + m2 * d * d * x);
        const double newton = x - value / select(rise > 0, rise, least_slope);
        // Beside the root on its lower side the function may fall: then from the high end.
        const double next = select(rise > 0, newton, cells.high[i]);
        const double better = smaller(larger(next, cells.low[i]), cells.high[i]);
        cells.sine[i] = better;
        steps[i] = std::abs(better - x) - step_share * better;
    }
    return *std::ranges::max_element(steps);
}

// The heights where the cutter is lowest.
ENDMILL_WIDEST_REGISTERS
void heights_between(const Passed& cells, const SweptMove& move, double lower_side,
                     const Shape& shape, Lanes& heights)
{
    for (int i = 0; i < side; ++i) {
        const double s = cells.s[i];
        const double e = std::abs(cells.e[i]);
        const double d = shape.c + shape.r * cells.sine[i];
        const double t2 = (d - e) * (d + e);
        const double root = std::sqrt(select(t2 > 0, t2, 0));
        const double t = smaller(larger(root, cells.t_low[i]), cells.t_high[i]);
        const double place = s + lower_side * t;
        const double along = smaller(larger(place, 0), move.length);
        const double rest = s - along;
        const double distance = std::sqrt(e * e + rest * rest);
        const double a = smaller(larger(distance - shape.c, 0), shape.r);
        const double up = shape.r - std::sqrt((shape.r - a) * (shape.r + a));
        const double q = (shape.R - e) * (shape.R + e);
        const double w = std::sqrt(select(q > 0, q, 0));
        const double reached = smaller(move.length - (s - w), s + w);
        const double swept = move.z + move.slope * along + up;
        heights[i] = select(smaller(q, reached) >= 0, swept, infinite);
    }
}

// Lowers the heights of up to eight cells to what the cutter leaves between the ends.
void lower_between(std::span<const std::uint8_t> numbers, const TilePlace& place,
                   const SweptMove& move, const Shape& shape, TileHeights& heights)
{
    Passed cells;
    for (std::size_t i = 0; i < side; ++i) {
        const int number = numbers[std::min(i, numbers.size() - 1)];
        const double dx = place.x[number % side] - move.x;
        const double dy = place.y[number / side] - move.y;
        cells.s[i] = dx * move.direction_x + dy * move.direction_y;
        cells.e[i] = dy * move.direction_x - dx * move.direction_y;
    }
    const double lower_side = move.slope > 0 ? -1 : 1;
    bracket(cells, move.length, lower_side, shape);
    for (int k = 0; k < most_iterations; ++k)
        if (!(improve(cells, std::abs(move.slope), shape) > 0))
            break;
    Lanes found;
    heights_between(cells, move, lower_side, shape, found);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        heights[numbers[i]] = std::min(heights[numbers[i]], found[i]);
}

using CellNumbers = std::array<std::uint8_t, HeightStock::tile_size>;

// The numbers of the cells with a number below 0, and how many they are.
std::size_t numbers_below_zero(const TileHeights& open, CellNumbers& numbers)
{
    std::size_t count = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
        numbers[count] = static_cast<std::uint8_t>(k);
        count += open[k] < 0 ? 1 : 0;
    }
    return count;
}

}  // namespace

void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, TileHeights& heights)
{
    const Shape shape{cutter.radius(), cutter.corner_radius(), cutter.flat_radius()};
    if (move.slope == 0) {
        level_bull_heights(place, move, shape, heights);
        return;
    }
    TileHeights open;
    if (move.is_continued) {
        look_from_end(tile.data(), place, move, shape, heights.data(), open.data());
    } else {
        SweptMove start = move;
        start.length = 0;
        TileHeights known;
        level_bull_heights(place, start, shape, known);
        TileHeights lowered;
        for (int k = 0; k < HeightStock::tile_size; ++k)
            lowered[k] = smaller(tile[k], known[k]);
        look_from_end(lowered.data(), place, move, shape, heights.data(), open.data());
        for (int k = 0; k < HeightStock::tile_size; ++k)
            heights[k] = smaller(heights[k], known[k]);
    }
    CellNumbers numbers;
    std::size_t count = numbers_below_zero(open, numbers);
    if (count > side) {
        look_from_start(place, move, shape, open.data());
        count = numbers_below_zero(open, numbers);
    }
    for (std::size_t first = 0; first < count; first += side)
        lower_between(
            std::span{numbers}.subspan(first, std::min<std::size_t>(side, count - first)),
            place, move, shape, heights);
}

}  // namespace endmill
