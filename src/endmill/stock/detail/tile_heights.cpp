// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_heights.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
constexpr double infinite = std::numeric_limits<double>::infinity();
// Exceeds the relative rounding errors of m |m| q.
constexpr double turn_rounding = 1e-14;

// Whether the minimum of S lies at the end of the move over every cell that the ball
// reaches. `rest`, the way from the end of the move to a cell, is least at a corner of the
// tile; this also holds for the rounded values, because rounding is monotone.
bool is_beyond_end(const TilePlace& place, const SweptMove& move, double R)
{
    double rest = infinite;
    for (const double x : {place.x.front(), place.x.back()})
        for (const double y : {place.y.front(), place.y.back()}) {
            const double s =
                (x - move.x) * move.direction_x + (y - move.y) * move.direction_y;
            rest = std::min(rest, s - move.length);
        }
    const double m = move.slope;
    // An upper bound of m |m| q where q >= 0.
    const double turn = m > 0 ? m * m * R * R * (1 + turn_rounding) : 0;
    return rest > 0 && rest * rest * (1 + m * m) > turn;
}

// S of a ball over cells beyond the end of the move, where the ball is lowest at its end.
// The numbers are those of `ball_heights_along`.
ENDMILL_WIDEST_REGISTERS
void ball_heights_beyond(const TilePlace& place, const SweptMove& move, double R,
                         double* __restrict heights)
{
    const TileOfMove cells{place, move};
    const double length = move.length;
    const double end_z = move.z + move.rise;
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const CellOfMove cell = cells.cell(i, j);
            const double rest = cell.s - length;
            const double square = cell.q(R) - rest * rest;
            const double swept = end_z + (R - std::sqrt(std::abs(square)));
            heights[j * side + i] = select(square >= 0, swept, infinite);
        }
    }
}

// S of a ball. With w^2 = q and k = 1 + m^2 the unclamped position of the minimum is s -
// m w / sqrt(k). It lies before the start of the move if s |s| k < m |m| q, and beyond
// its end by the corresponding test. So one root per cell is enough.
// Source: docs/methods/removal.md, section 1.
ENDMILL_WIDEST_REGISTERS
void ball_heights_along(const TilePlace& place, const SweptMove& move, double R,
                        TileHeights& heights)
{
    const TileOfMove cells{place, move};
    const double m = move.slope;
    const double k = 1 + m * m;
    const double length = move.length;
    const double rise = move.rise;
    const double z = move.z;
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const CellOfMove cell = cells.cell(i, j);
            const double s = cell.s;
            const double q = cell.q(R);
            const double rest = s - length;
            const double turn = m * std::abs(m) * q;
            const bool is_before = s * std::abs(s) * k < turn;
            const bool is_beyond = rest * std::abs(rest) * k > turn;
            const double at_start = q - s * s;
            const double at_end = q - rest * rest;
            const double between = q * k;
            const double rise_so_far = m * s;
            const double late = select(is_beyond, at_end, between);
            const double late_rise = select(is_beyond, rise, rise_so_far);
            const double square = select(is_before, at_start, late);
            const double risen = select(is_before, 0, late_rise);
            const double least = select(q < square, q, square);
            const double swept = z + risen + (R - std::sqrt(std::abs(square)));
            heights[j * side + i] = select(least >= 0, swept, infinite);
        }
    }
}

}  // namespace

void ball_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights)
{
    if (is_beyond_end(place, move, R))
        ball_heights_beyond(place, move, R, heights.data());
    else
        ball_heights_along(place, move, R, heights);
}

// S of a flat cutter. Over a cell the cutter is lowest at one end of the range of
// positions that cover the cell.
// Source: docs/methods/removal.md, section 1.
ENDMILL_WIDEST_REGISTERS
void flat_heights(const TilePlace& place, const SweptMove& move, double R,
                  TileHeights& heights)
{
    const TileOfMove cells{place, move};
    const double m = move.slope;
    const double length = move.length;
    const double z = move.z;
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const CellOfMove cell = cells.cell(i, j);
            const double q = cell.q(R);
            const double w = std::sqrt(std::abs(q));
            const double first = cell.s - w;
            const double last = cell.s + w;
            const double low = select(first > 0, first, 0);
            const double high = select(last < length, last, length);
            const double along = select(m > 0, low, high);
            const double swept = select(low <= high, z + m * along, infinite);
            heights[j * side + i] = select(q >= 0, swept, infinite);
        }
    }
}

TilePlace tile_place(const StockGrid& grid, int tile_column, int tile_row)
{
    TilePlace place{};
    for (int k = 0; k < side; ++k) {
        place.x[k] = grid.x(tile_column * side + k);
        place.y[k] = grid.y(tile_row * side + k);
    }
    place.bottom_z = grid.bottom_z;
    return place;
}

}  // namespace endmill
