// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/bull_heights.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "endmill/core/detail/widest_registers.h"

// The height S of a cell under a bull-nose cutter on a sloped move is the minimum, over
// the positions u of the axis along the move, of the convex function z(u) +
// profile(d(u)), where d(u) is the distance of the cell from the axis.
// 1. `heights_at_end` evaluates the end of the move for all 64 cells. A tangent there, or
//    the fact that the cutter has left the cell, shows for most cells that no position is
//    lower than the cell's current height. The others are marked open.
// 2. If more than eight cells are open, `close_rising_cells` closes those over which the
//    cutter rises from the start on, because their minimum is at the start.
// 3. `lower_between` solves for the minimum of the open cells, eight at a time:
//    `bracket_positions` bounds the position, `newton_step` does Newton steps for the
//    sine of the corner's angle, `heights_between` evaluates S.
//
// A level move needs none of this: the nearest position is the lowest
// (`level_bull_heights`).
// Source: docs/methods/removal.md, section 1.

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Least slope of a Newton step; it only prevents a division by zero.
constexpr double least_slope = 1e-200;  // mm^2
// Newton's iteration stops at steps below this share of the sine; the error after such a
// step is about its square.
constexpr double step_share = 1e-7;
// Limit of Newton's iteration. From above the root of a convex function it needs about
// five steps on a short move and sixty where the slope is nearly zero.
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

// A flat bottom of radius c with a corner of radius r around it; R = c + r.
struct Shape {
    double R;
    double r;
    double c;
};

// S of a move that stays level or does not move.
ENDMILL_WIDEST_REGISTERS
void level_bull_heights(const TilePlace& place, const SweptMove& move, const Shape& shape,
                        TileHeights& heights)
{
    const TileOfMove cells{place, move};
    const double r = shape.r;
    const double length = move.length;
    const double z = move.z;
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const auto [s, e] = cells.cell(i, j);
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

// Computes the heights under the end of the move, infinite where the cell is out of
// reach. `open` is below 0 for the cells where the cutter may have been lower, and lower
// than `tile`, before the end.
ENDMILL_WIDEST_REGISTERS
void heights_at_end(const double* __restrict tile, const TilePlace& place,
                    const SweptMove& move, Shape shape, double* __restrict heights,
                    double* __restrict open)
{
    const TileOfMove cells{place, move};
    const double m = move.slope;
    const double length = move.length;
    const double z = move.z + move.rise;
    // The cutter has left a cell that is out of reach at the end. Such a cell lies within
    // `length` of the rim during the whole move, which bounds the height from below.
    const double near_rim = larger(shape.r - length, 0);
    const double lowest = smaller(move.z, z) + shape.r -
                          std::sqrt((shape.r - near_rim) * (shape.r + near_rim));
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const int k = j * side + i;
            const CellOfMove cell = cells.cell(i, j);
            const double t = cell.s - length;
            const double e = cell.e;
            const double distance = std::sqrt(e * e + t * t);
            const double out = distance - shape.c;
            const double a = select(out > 0, out, 0);
            const double root = std::sqrt(std::abs((shape.r - a) * (shape.r + a)));
            const double under = z + (shape.r - root);
            // Tangent of the height as a function of the position, at the end, extended
            // backwards over the whole move. All terms are multiplied by root * distance.
            const double steep = root * distance;
            const double rise = m * steep - a * t;
            const double above = (under - tile[k]) * steep - rise * length;
            const double tangent = select(rise > 0, above, 1);
            const double missed = larger(larger(t, -cell.s - shape.R), lowest - tile[k]);
            const double left = select(cell.q(shape.R) >= 0, missed, 1);
            heights[k] = select(distance <= shape.R, under, infinite);
            open[k] = select(distance <= shape.R, tangent, left);
        }
    }
}

// Keeps only those cells open over which the cutter sinks at the start of the move. Over
// the others it is lowest at the start. The test compares m with profile'(d) t / d in
// squared form, without the roots.
ENDMILL_WIDEST_REGISTERS
void close_rising_cells(const TilePlace& place, const SweptMove& move, Shape shape,
                        double* __restrict open)
{
    const TileOfMove cells{place, move};
    const double slope2 = move.slope * std::abs(move.slope);
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const auto [s, e] = cells.cell(i, j);
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

// Up to eight cells over which the cutter passes between the ends of its move.
struct Passed {
    Lanes s;  // mm, along the move from its start
    Lanes e;  // mm, across the move
    // Distance along the move from the cell to the axis, on the side where the cutter is
    // lower: its range; and the sine of the corner's angle over the cell: its range and
    // its current value.
    Lanes t_low;
    Lanes t_high;
    Lanes low;
    Lanes high;
    Lanes sine;
};

// Bounds the positions at which the cutter is over each cell. The sine starts in the
// middle of its range.
ENDMILL_WIDEST_REGISTERS
void bracket_positions(Passed& cells, double length, double lower_side,
                       const Shape& shape)
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

// Does one step of Newton's method for the sine x of the corner's angle. The cutter is
// lowest over the cell where x t = m sqrt(1 - x^2) d, with d = c + r x and t^2 = d^2 -
// e^2. The difference of the squared sides is a convex function of x from its root on.
// Source: docs/methods/removal.md, section 1: profile'(d) t / d = m, written in the
// corner's angle.
// \return the longest step, minus `step_share` of the sine; not above 0 if converged.
ENDMILL_WIDEST_REGISTERS
double newton_step(Passed& cells, double m, const Shape& shape)
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
        // On the lower side of the root the function may fall. Then the iteration
        // restarts from the upper end.
        const double next = select(rise > 0, newton, cells.high[i]);
        const double better = smaller(larger(next, cells.low[i]), cells.high[i]);
        cells.sine[i] = better;
        steps[i] = std::abs(better - x) - step_share * better;
    }
    return *std::ranges::max_element(steps);
}

// Computes the heights at the positions found.
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

// Lowers the heights of up to eight cells to the minimum between the ends of the move.
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
    bracket_positions(cells, move.length, lower_side, shape);
    for (int k = 0; k < most_iterations; ++k)
        if (!(newton_step(cells, std::abs(move.slope), shape) > 0))
            break;
    Lanes found;
    heights_between(cells, move, lower_side, shape, found);
    for (std::size_t i = 0; i < numbers.size(); ++i)
        heights[numbers[i]] = std::min(heights[numbers[i]], found[i]);
}

using CellNumbers = std::array<std::uint8_t, HeightStock::tile_size>;

// Lists the cells whose number in `open` is below 0. \return their number.
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
        heights_at_end(tile.data(), place, move, shape, heights.data(), open.data());
    } else {
        SweptMove start = move;
        start.length = 0;
        TileHeights known;
        level_bull_heights(place, start, shape, known);
        TileHeights lowered;
        for (int k = 0; k < HeightStock::tile_size; ++k)
            lowered[k] = smaller(tile[k], known[k]);
        heights_at_end(lowered.data(), place, move, shape, heights.data(), open.data());
        for (int k = 0; k < HeightStock::tile_size; ++k)
            heights[k] = smaller(heights[k], known[k]);
    }
    CellNumbers numbers;
    std::size_t count = numbers_below_zero(open, numbers);
    if (count > side) {
        close_rising_cells(place, move, shape, open.data());
        count = numbers_below_zero(open, numbers);
    }
    for (std::size_t first = 0; first < count; first += side)
        lower_between(
            std::span{numbers}.subspan(first, std::min<std::size_t>(side, count - first)),
            place, move, shape, heights);
}

}  // namespace endmill
