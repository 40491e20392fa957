// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/bull_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/simulation/widest_registers.h"

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Keep a division by the distance from the axis, or by the root at the rim, a number.
constexpr double least_distance2 = 1e-200;  // mm^2
constexpr double least_root = 1e-200;       // mm
// Of the position: the height is stationary there, so that it is off by the square.
constexpr double position_share = 1e-9;  // of the cutter's radius
// More than a bracket of doubles can be halved, with Newton's steps between.
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

// The cells of a tile against a move: s along and e across it from its start.
struct TileLines {
    TileHeights s;
    TileHeights e;
};

// The cells of a tile under one end of a move.
struct UnderEnd {
    TileHeights z;      // of the cutter over the cell
    TileHeights slope;  // how fast that rises as the cutter goes on
    TileHeights gap;    // from the cutter's rim to the cell; positive where out of reach
};

struct UnderEnds {
    UnderEnd first;
    UnderEnd last;
};

// The cutter at `along` of the move.
ENDMILL_WIDEST_REGISTERS
void look_from(double along, const TileLines& lines, const SweptMove& move, Shape shape,
               UnderEnd& under)
{
    const double m = move.slope;
    const double z = move.z + m * along;
    for (int k = 0; k < HeightStock::tile_size; ++k) {
        const double e = lines.e[k];
        const double t = lines.s[k] - along;
        const double distance = std::sqrt(e * e + t * t + least_distance2);
        const double out = distance - shape.c;
        const double a = select(out > 0, out, 0);
        const double root = std::sqrt(std::abs((shape.r - a) * (shape.r + a)));
        under.z[k] = z + (shape.r - root);
        under.slope[k] = m - a * t / (root * distance + least_root);
        under.gap[k] = distance - shape.R;
    }
}

// The height where it is least at an end of the move; elsewhere infinite in `heights`,
// with a lower bound in `bounds`.
ENDMILL_WIDEST_REGISTERS
void heights_at_ends(const TileLines& lines, double length, const UnderEnds& ends,
                     TileHeights& heights, TileHeights& bounds)
{
    const UnderEnd& first = ends.first;
    const UnderEnd& last = ends.last;
    for (int k = 0; k < HeightStock::tile_size; ++k) {
        const double z0 = first.z[k];
        const double z1 = last.z[k];
        const double crossing =
            (z1 - z0 - last.slope[k] * length) / (first.slope[k] - last.slope[k]);
        const double tangents = z0 + first.slope[k] * crossing;
        const double number = select(tangents < infinite, tangents, -infinite);
        const double gap = larger(first.gap[k], last.gap[k]);
        const double bound = select(gap <= 0, number, -infinite);
        // Before the start, or beyond the end, and out of reach from there.
        const double missed_first = smaller(-lines.s[k], first.gap[k]);
        const double missed_last = smaller(lines.s[k] - length, last.gap[k]);
        const double unknown =
            select(larger(missed_first, missed_last) > 0, infinite, bound);
        // Reached from an end from which the height rises.
        const double is_first = smaller(-first.gap[k], first.slope[k]);
        const double is_last = smaller(-last.gap[k], -last.slope[k]);
        const double at_last = select(is_last >= 0, z1, infinite);
        const double found = select(is_first >= 0, z0, at_last);
        heights[k] = found;
        bounds[k] = select(larger(is_first, is_last) >= 0, found, unknown);
    }
}

// Cells whose height is least between the ends: with t = |u - s| on the side where the
// cutter is lower, a t / d = |m| sqrt(r^2 - a^2), d^2 = e^2 + t^2, a = d - c.
struct Between {
    Lanes e2;
    Lanes low;   // of t
    Lanes high;  // of t
    Lanes t;
};

// One step of Newton's iteration in each lane, kept in its bracket.
// \return the longest step
ENDMILL_WIDEST_REGISTERS
double improve(Between& between, double m, const Shape& shape)
{
    Lanes steps;
    for (int i = 0; i < side; ++i) {
        const double t = between.t[i];
        const double d = std::sqrt(between.e2[i] + t * t + least_distance2);
        const double out = d - shape.c;
        const double a = select(out > 0, out, 0);
        const double root = std::sqrt(std::abs((shape.r - a) * (shape.r + a)));
        const double share = t / d;
        const double value = a * share - m * root;
        const double rise = share * share + a * between.e2[i] / (d * d * d) +
                            m * a * share / (root + least_root);
        const double low = select(value < 0, t, between.low[i]);
        const double high = select(value > 0, t, between.high[i]);
        const double newton = t - value / rise;
        const double middle = low + (high - low) / 2;
        const double above = select(newton > low, newton, middle);
        const double next = select(newton < high, above, middle);
        const double better = select(value == 0, t, next);
        between.low[i] = low;
        between.high[i] = high;
        between.t[i] = better;
        steps[i] = std::abs(better - t);
    }
    return *std::ranges::max_element(steps);
}

// Up to eight cells of a tile, given by their numbers.
class CellsBetween {
public:
    CellsBetween(const SweptMove& move, const Shape& shape)
        : move_{move},
          shape_{shape},
          m_{std::abs(move.slope)},
          side_{move.slope > 0 ? -1.0 : 1.0}
    {
        // The tilt of the tube on the line itself: a good first guess also beside it.
        const double tilted = shape.c + shape.r * m_ / std::sqrt(1 + m_ * m_);
        tilted2_ = tilted * tilted;
    }

    bool is_full() const { return count_ == side; }

    void add(int cell, double s, double e)
    {
        const double w = std::sqrt(std::max(0.0, (shape_.R - e) * (shape_.R + e)));
        const double from = std::max(0.0, s - w);
        const double to = std::min(move_.length, s + w);
        const double low = std::max(0.0, select(side_ > 0, from - s, s - to));
        const double high = std::max(low, select(side_ > 0, to - s, s - from));
        cells_[count_] = cell;
        s_[count_] = s;
        set(count_, e * e, low, high);
        ++count_;
    }

    // Finds the heights of all that were added, and forgets them.
    void solve(TileHeights& heights)
    {
        if (count_ == 0)
            return;
        for (int i = count_; i < side; ++i)
            set(i, between_.e2[0], between_.low[0], between_.high[0]);
        for (int k = 0; k < most_iterations; ++k)
            if (!(improve(between_, m_, shape_) > position_share * shape_.R))
                break;
        for (int i = 0; i < count_; ++i)
            heights[cells_[i]] = height(i);
        count_ = 0;
    }

private:
    void set(int lane, double e2, double low, double high)
    {
        between_.e2[lane] = e2;
        between_.low[lane] = low;
        between_.high[lane] = high;
        between_.t[lane] = std::clamp(std::sqrt(std::max(0.0, tilted2_ - e2)), low, high);
    }

    double height(int lane) const
    {
        const double t = between_.t[lane];
        const double along = s_[lane] + side_ * t;
        const double d = std::sqrt(between_.e2[lane] + t * t);
        const double a = std::clamp(d - shape_.c, 0.0, shape_.r);
        return move_.z + move_.slope * along +
               (shape_.r - std::sqrt((shape_.r - a) * (shape_.r + a)));
    }

    const SweptMove& move_;
    const Shape& shape_;
    double m_;
    double side_;  // of s on which the least lies
    double tilted2_;
    int count_ = 0;
    std::array<int, side> cells_;
    Lanes s_;
    Between between_;
};

}  // namespace

void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, TileHeights& heights)
{
    const Shape shape{cutter.radius(), cutter.corner_radius(), cutter.flat_radius()};
    if (move.slope == 0) {
        level_bull_heights(place, move, shape, heights);
        return;
    }
    TileLines lines;
    for (int j = 0; j < side; ++j) {
        const TileRow row = tile_row(place, j, move, shape.R);
        std::ranges::copy(row.s, lines.s.begin() + j * side);
        std::ranges::copy(row.e, lines.e.begin() + j * side);
    }
    UnderEnds ends;
    look_from(0, lines, move, shape, ends.first);
    look_from(move.length, lines, move, shape, ends.last);
    TileHeights bounds;
    heights_at_ends(lines, move.length, ends, heights, bounds);
    CellsBetween between{move, shape};
    for (int k = 0; k < HeightStock::tile_size; ++k)
        if (bounds[k] < heights[k] && bounds[k] < tile[k] &&
            std::abs(lines.e[k]) <= shape.R) {
            between.add(k, lines.s[k], lines.e[k]);
            if (between.is_full())
                between.solve(heights);
        }
    between.solve(heights);
}

}  // namespace endmill
