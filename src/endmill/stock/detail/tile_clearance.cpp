// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/tile_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/detail/widest_registers.h"

// Most moves near a tile do not touch it. `may_touch` rejects them without evaluating the
// cells. A tile is represented by a plane above its heights. The volume that a move
// sweeps is convex, so a plane separates the two if they are disjoint. The test takes the
// point of the swept disc that is nearest to the middle of the tile and uses the plane
// perpendicular to the line between them. It compares two support functions: the least
// value over the sweep and the greatest over the tile.

namespace endmill {
namespace {

constexpr int side = HeightStock::tile_side;
// Share of the largest coordinate that bounds the rounding errors, some hundred roundings
// of a double, so that no move is rejected by rounding.
constexpr double rounding_share = 1e-13;

// Sum of the squared distances of the cells from the middle along one axis, in cells: 8
// rows of 2 (0.5^2 + 1.5^2 + 2.5^2 + 3.5^2). The least-squares slope is the moment
// divided by it.
constexpr double sum_of_squares = 8 * 42.0;

// Places of the columns and rows, in cells from the middle of the tile.
constexpr std::array<double, side> from_middle{-3.5, -2.5, -1.5, -0.5,
                                               0.5,  1.5,  2.5,  3.5};

// Fits a plane to the heights by least squares and raises it above all of them.
ENDMILL_WIDEST_REGISTERS
void fit_plane(const double* tile, double pitch, UpperPlane& top)
{
    std::array<double, side> columns{};
    std::array<double, side> moments{};
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            columns[i] += tile[j * side + i];
            moments[i] += from_middle[j] * tile[j * side + i];
        }
    }
    double along_x = 0;
    double along_y = 0;
    for (int i = 0; i < side; ++i) {
        along_x += from_middle[i] * columns[i];
        along_y += moments[i];
    }
    const double rise_x = along_x / sum_of_squares;  // per cell
    const double rise_y = along_y / sum_of_squares;
    std::array<double, side> rises;
    std::array<double, side> highest;
    for (int i = 0; i < side; ++i) {
        rises[i] = from_middle[i] * rise_x;
        highest[i] = -std::numeric_limits<double>::infinity();
    }
    for (int j = 0; j < side; ++j) {
        ENDMILL_NOT_UNROLLED
        for (int i = 0; i < side; ++i) {
            const double over = tile[j * side + i] - (rises[i] + from_middle[j] * rise_y);
            highest[i] = over > highest[i] ? over : highest[i];
        }
    }
    top.slope_x = rise_x / pitch;
    top.slope_y = rise_y / pitch;
    top.z = *std::ranges::max_element(highest);
}

// Tests the moves of a disc of radius `c`, or of a ball if `is_ball`: then nothing is
// divided, and only the length of |v|^2 is needed.
template <bool is_ball>
[[gnu::always_inline]] inline void test_moves(const UpperPlane& top,
                                              const MoveBatch& batch,
                                              const SweptDisc& disc, MoveRange range,
                                              std::uint8_t* touches)
{
    const double c = is_ball ? 0 : disc.flat_radius;
    const double top_z = top.z - disc.above;
    const double half = top.half_width;
    for (int k = range.first; k < range.last; ++k) {
        // p: from the middle of the disc at the start of the move to the middle of the
        // tile.
        const double px = top.x - batch.x[k];
        const double py = top.y - batch.y[k];
        const double pz = top_z - batch.z[k];
        const double dx = batch.dx[k];
        const double dy = batch.dy[k];
        const double dz = batch.dz[k];
        const double nearest = (px * dx + py * dy + pz * dz) * batch.per_length2[k];
        const double positive = select(nearest > 0, nearest, 0);
        const double share = select(positive < 1, positive, 1);
        double vx = px - share * dx;
        double vy = py - share * dy;
        double vz = pz - share * dz;
        // v: from the nearest point of the disc to the middle of the tile. Its upward
        // part is removed, because everything above the disc is swept too.
        double beside = 0;
        double beside2 = vx * vx + vy * vy;
        if constexpr (!is_ball) {
            const double across = std::sqrt(beside2);
            beside = select(across > c, across - c, 0);
            const double kept = select(across > c, beside / across, 0);
            vx *= kept;
            vy *= kept;
            beside2 = beside * beside;
        }
        vz = vz < 0 ? vz : 0;
        const double at_start = vx * px + vy * py + vz * pz;
        const double turn = vx * dx + vy * dy + vz * dz;
        const double least = select(turn > 0, at_start - turn, at_start);
        const double tilt_x = std::abs(vx + vz * top.slope_x);
        const double tilt_y = std::abs(vy + vz * top.slope_y);
        const double r = disc.corner_radius + top.margin +
                         rounding_share * (std::abs(px) + std::abs(py) + std::abs(pz));
        // The sweep is clear if `apart` exceeds r |v|. Comparing the squares with their
        // signs avoids the root.
        const double apart = least - (tilt_x + tilt_y) * half - c * beside;
        const double v2 = beside2 + vz * vz;
        const bool is_clear = apart * std::abs(apart) > r * r * v2;
        touches[k] = is_clear ? 0 : 1;
    }
}

ENDMILL_WIDEST_REGISTERS
void test_balls(const UpperPlane& top, const MoveBatch& batch, const SweptDisc& disc,
                MoveRange range, std::uint8_t* touches)
{
    test_moves<true>(top, batch, disc, range, touches);
}

ENDMILL_WIDEST_REGISTERS
void test_discs(const UpperPlane& top, const MoveBatch& batch, const SweptDisc& disc,
                MoveRange range, std::uint8_t* touches)
{
    test_moves<false>(top, batch, disc, range, touches);
}

}  // namespace

UpperPlane upper_plane(HeightStock::ConstTile tile, const TilePlace& place)
{
    const double pitch = place.x[1] - place.x[0];
    UpperPlane top{};
    fit_plane(tile.data(), pitch, top);
    top.x = (place.x.front() + place.x.back()) / 2;
    top.y = (place.y.front() + place.y.back()) / 2;
    top.half_width = (place.x.back() - place.x.front()) / 2;
    top.margin = rounding_share *
                 (std::abs(top.x) + std::abs(top.y) + std::abs(top.z) +
                  (1 + std::abs(top.slope_x) + std::abs(top.slope_y)) * top.half_width);
    return top;
}

UpperPlane common_upper_plane(std::span<const UpperPlane> tops)
{
    UpperPlane common{};
    double low_x = tops.front().x;
    double low_y = tops.front().y;
    double high_x = low_x;
    double high_y = low_y;
    for (const UpperPlane& top : tops) {
        low_x = std::min(low_x, top.x);
        low_y = std::min(low_y, top.y);
        high_x = std::max(high_x, top.x);
        high_y = std::max(high_y, top.y);
        common.slope_x += top.slope_x / static_cast<double>(tops.size());
        common.slope_y += top.slope_y / static_cast<double>(tops.size());
        common.margin = std::max(common.margin, top.margin);
    }
    common.x = (low_x + high_x) / 2;
    common.y = (low_y + high_y) / 2;
    common.half_width =
        std::max(high_x - low_x, high_y - low_y) / 2 + tops.front().half_width;
    common.z = -std::numeric_limits<double>::infinity();
    // The difference of two planes over a tile is greatest at a corner of the tile.
    for (const UpperPlane& top : tops)
        common.z = std::max(common.z, top.z + (common.x - top.x) * common.slope_x +
                                          (common.y - top.y) * common.slope_y +
                                          (std::abs(top.slope_x - common.slope_x) +
                                           std::abs(top.slope_y - common.slope_y)) *
                                              top.half_width);
    // The sums above have about ten times as many roundings as those of a tile.
    common.margin *= 10;
    return common;
}

void MoveBatch::keep(const std::uint8_t* kept)
{
    int next = 0;
    for (int k = 0; k < count; ++k) {
        x[next] = x[k];
        y[next] = y[k];
        z[next] = z[k];
        dx[next] = dx[k];
        dy[next] = dy[k];
        dz[next] = dz[k];
        per_length2[next] = per_length2[k];
        number[next] = number[k];
        next += kept[k] ? 1 : 0;
    }
    count = next;
}

void MoveBatch::add(const SweptMove& move, std::uint32_t its_number)
{
    const double length2 = move.length * move.length + move.rise * move.rise;
    x[count] = move.x;
    y[count] = move.y;
    z[count] = move.z;
    dx[count] = move.length * move.direction_x;
    dy[count] = move.length * move.direction_y;
    dz[count] = move.rise;
    // For a shorter move the position on it does not matter, and its reciprocal would
    // overflow.
    per_length2[count] =
        length2 > 1 / std::numeric_limits<double>::max() ? 1 / length2 : 0;
    number[count] = its_number;
    ++count;
}

void may_touch(const UpperPlane& top, const MoveBatch& batch, const SweptDisc& disc,
               MoveRange range, std::uint8_t* touches)
{
    if (disc.flat_radius > 0)
        test_discs(top, batch, disc, range, touches);
    else
        test_balls(top, batch, disc, range, touches);
}

}  // namespace endmill
