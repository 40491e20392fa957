// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/tile_cut.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/simulation/widest_registers.h"

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
constexpr double infinite = std::numeric_limits<double>::infinity();

using Cells = std::array<double, HeightStock::tile_size>;

// A flat bottom of radius c with a corner of radius r around it.
struct Shape {
    double R;
    double r;
    double c;
};

// S under a ball. With w^2 = q, k = 1 + m^2 the unclamped position s - m w / sqrt(k) lies
// before the move's start if s |s| k < m |m| q, and beyond its end alike; so one root a
// cell is enough. Source: spec of the removal, section 1.
ENDMILL_WIDEST_REGISTERS
void ball_heights(const TilePlace& place, const SweptMove& move, double R, Cells& heights)
{
    const double k = 1 + move.slope * move.slope;
    const double turn = move.slope * std::abs(move.slope);
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double dx = place.x[i] - move.x;
            const double dy = place.y[j] - move.y;
            const double s = dx * move.direction_x + dy * move.direction_y;
            const double e = dy * move.direction_x - dx * move.direction_y;
            const double q = (R - e) * (R + e);
            const double rest = s - move.length;
            const bool is_before = s * std::abs(s) * k < turn * q;
            const bool is_beyond = rest * std::abs(rest) * k > turn * q;
            const double between = move.slope * s;
            const double rise = is_before ? 0 : (is_beyond ? move.rise : between);
            const double under_root =
                is_before ? q - s * s : (is_beyond ? q - rest * rest : q * k);
            const double root = std::sqrt(under_root > 0 ? under_root : 0);
            const double z = move.z + rise + (R - root);
            const bool is_under = q >= 0 && under_root >= 0;
            heights[j * side + i] = is_under ? z : infinite;
        }
}

// S under a flat cutter: at the end of its way over the cell where it is lower.
ENDMILL_WIDEST_REGISTERS
void flat_heights(const TilePlace& place, const SweptMove& move, double R, Cells& heights)
{
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double dx = place.x[i] - move.x;
            const double dy = place.y[j] - move.y;
            const double s = dx * move.direction_x + dy * move.direction_y;
            const double e = dy * move.direction_x - dx * move.direction_y;
            const double q = (R - e) * (R + e);
            const double w = std::sqrt(q > 0 ? q : 0);
            const double low = s - w > 0 ? s - w : 0;
            const double high = s + w < move.length ? s + w : move.length;
            const double along = move.slope > 0 ? low : high;
            const bool is_under = q >= 0 && low <= high;
            heights[j * side + i] = is_under ? move.z + move.slope * along : infinite;
        }
}

// S under a bull-nose cutter that stays level, or does not move.
ENDMILL_WIDEST_REGISTERS
void level_bull_heights(const TilePlace& place, const SweptMove& move, const Shape& shape,
                        Cells& heights)
{
    const double r = shape.r;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double dx = place.x[i] - move.x;
            const double dy = place.y[j] - move.y;
            const double s = dx * move.direction_x + dy * move.direction_y;
            const double e = dy * move.direction_x - dx * move.direction_y;
            const double beyond = s - move.length > 0 ? s - move.length : 0;
            const double t = s < 0 ? s : beyond;
            const double distance = std::sqrt(e * e + t * t);
            const double out = distance - shape.c;
            const double a = out > 0 ? out : 0;
            const double under_root = (r - a) * (r + a);
            const double root = std::sqrt(under_root > 0 ? under_root : 0);
            heights[j * side + i] = distance <= shape.R ? move.z + (r - root) : infinite;
        }
}

// The height over a cell of a bull-nose cutter at one end of its move, and how fast that
// rises as the cutter goes on.
struct AtEnd {
    double z;  // infinite where the cutter does not reach
    double slope;
};

inline AtEnd at_end(double t, double e2, double m, const Shape& shape)
{
    // Keeps the direction of a cell on the axis, where it does not matter, a number.
    constexpr double least_distance = 1e-300;
    const double distance = std::sqrt(e2 + t * t);
    const double out = distance - shape.c;
    const double a = out > 0 ? out : 0;
    const double under_root = (shape.r - a) * (shape.r + a);
    const double root = std::sqrt(under_root > 0 ? under_root : 0);
    const double d = distance > least_distance ? distance : least_distance;
    return {distance <= shape.R ? shape.r - root : infinite, m - a * t / (root * d)};
}

// S under a bull-nose cutter where it is found at an end of the move; elsewhere infinite
// in `heights`, with a lower bound in `bounds`: S is the least of a convex function of the
// position, which lies above its tangents at both ends.
ENDMILL_WIDEST_REGISTERS
void sloped_bull_heights(const TilePlace& place, const SweptMove& move,
                         const Shape& shape, Cells& heights, Cells& bounds)
{
    const double L = move.length;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double dx = place.x[i] - move.x;
            const double dy = place.y[j] - move.y;
            const double s = dx * move.direction_x + dy * move.direction_y;
            const double e = dy * move.direction_x - dx * move.direction_y;
            const AtEnd first = at_end(s, e * e, move.slope, shape);
            const AtEnd last = at_end(s - L, e * e, move.slope, shape);
            const double z0 = move.z + first.z;
            const double z1 = move.z + move.rise + last.z;
            const bool at_first = z0 < infinite && first.slope >= 0;
            const bool at_last = z1 < infinite && last.slope <= 0;
            const bool reaches_both = z0 < infinite && z1 < infinite;
            const double crossing =
                (z1 - z0 - last.slope * L) / (first.slope - last.slope);
            const double tangents = z0 + first.slope * crossing;
            const double bound =
                reaches_both && tangents > -infinite ? tangents : -infinite;
            const bool is_missed = e * e > shape.R * shape.R ||
                                   (s < 0 && z0 == infinite) || (s > L && z1 == infinite);
            const double found = at_first ? z0 : (at_last ? z1 : infinite);
            heights[j * side + i] = found;
            bounds[j * side + i] = at_first || at_last || is_missed ? found : bound;
        }
}

void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, Cells& heights)
{
    const Shape shape{cutter.radius(), cutter.corner_radius(), cutter.flat_radius()};
    if (move.slope == 0) {
        level_bull_heights(place, move, shape, heights);
        return;
    }
    Cells bounds;
    sloped_bull_heights(place, move, shape, heights, bounds);
    const Vec3 from{move.x, move.y, move.z};
    const Vec3 way{move.length * move.direction_x, move.length * move.direction_y,
                   move.rise};
    const StraightSweep sweep{cutter, from, from + way};
    for (int k = 0; k < HeightStock::tile_size; ++k)
        if (bounds[k] < std::min(tile[k], heights[k]))
            heights[k] = sweep.height(place.x[k % side], place.y[k / side]);
}

ENDMILL_WIDEST_REGISTERS
TileCut lower(double* tile, double bottom_z, const Cells& heights)
{
    std::array<double, side> depths{};
    std::array<double, side> deepest{};
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const double before = tile[j * side + i];
            const double swept = heights[j * side + i];
            const double left = swept > bottom_z ? swept : bottom_z;
            const double after = left < before ? left : before;
            const double depth = before - after;
            tile[j * side + i] = after;
            depths[i] += depth;
            deepest[i] = depth > deepest[i] ? depth : deepest[i];
        }
    TileCut cut{0, 0};
    for (int i = 0; i < side; ++i) {
        cut.depths += depths[i];
        cut.deepest = std::max(cut.deepest, deepest[i]);
    }
    return cut;
}

}  // namespace

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

TileCut cut_tile(HeightStock::Tile tile, const TilePlace& place, const Cutter& cutter,
                 const SweptMove& move)
{
    Cells heights;
    if (cutter.is_ball())
        ball_heights(place, move, cutter.radius(), heights);
    else if (cutter.is_flat())
        flat_heights(place, move, cutter.radius(), heights);
    else
        bull_heights(tile, place, cutter, move, heights);
    return lower(tile.data(), place.bottom_z, heights);
}

double body_depth(HeightStock::ConstTile tile, const TilePlace& place,
                  const BodyCylinder& body, const SweptMove& move)
{
    Cells heights;
    flat_heights(place, move, body.radius, heights);
    double depth = 0;
    for (int k = 0; k < HeightStock::tile_size; ++k)
        if (tile[k] > place.bottom_z)
            depth = std::max(depth, tile[k] - (heights[k] + body.above));
    return depth;
}

double body_depth_on_arrival(HeightStock::ConstTile tile, const TilePlace& place,
                             const BodyCylinder& body, const SweptMove& move)
{
    double depth = 0;
    for (int k = 0; k < HeightStock::tile_size; ++k) {
        const double dx = place.x[k % side] - move.x;
        const double dy = place.y[k / side] - move.y;
        const double s = dx * move.direction_x + dy * move.direction_y;
        const double e = dy * move.direction_x - dx * move.direction_y;
        const double q = (body.radius - e) * (body.radius + e);
        if (q < 0 || tile[k] <= place.bottom_z)
            continue;
        const double arrival = s - std::sqrt(q);
        if (arrival > 0 && arrival <= move.length)
            depth =
                std::max(depth, tile[k] - (move.z + move.slope * arrival + body.above));
    }
    return depth;
}

}  // namespace endmill
