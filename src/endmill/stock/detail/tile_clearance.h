// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// A plane above all heights of a tile.
struct UpperPlane {
    double x;           ///< mm, middle of the tile
    double y;           ///< mm, middle of the tile
    double z;           ///< mm, height of the plane at the middle
    double slope_x;     ///< slope along x
    double slope_y;     ///< slope along y
    double half_width;  ///< mm, from the middle to the outermost centres of cells
    double margin;  ///< mm, exceeds the rounding errors of the tests against the plane
};

/// Returns the plane that fits the heights of the tile best, raised until it lies above
/// all of them.
UpperPlane upper_plane(HeightStock::ConstTile tile, const TilePlace& place);

/// Returns a plane above several tiles: the mean slope of their planes, raised until it
/// lies above all of them.
/// \pre `tops` is not empty.
UpperPlane common_upper_plane(std::span<const UpperPlane> tops);

/// Several moves as a structure of arrays, for loops that test many moves at once.
struct MoveBatch {
    static constexpr int capacity = 256;  ///< greatest number of moves

    std::array<double, capacity> x;            ///< mm, tip at the start of the move
    std::array<double, capacity> y;            ///< mm, tip at the start of the move
    std::array<double, capacity> z;            ///< mm, tip at the start of the move
    std::array<double, capacity> dx;           ///< mm, from the start to the end
    std::array<double, capacity> dy;           ///< mm, from the start to the end
    std::array<double, capacity> dz;           ///< mm, from the start to the end
    std::array<double, capacity> per_length2;  ///< 1 / |d|^2; 0 for a move without length
    std::array<std::uint32_t, capacity> number;  ///< of the move
    int count = 0;                               ///< of moves

    /// Appends a move. \pre count < capacity
    void add(const SweptMove& move, std::uint32_t its_number);

    /// Keeps the moves whose entry in `kept` is 1, in their order.
    void keep(const std::uint8_t* kept);
};

/// The shape that a tool sweeps: all points within `corner_radius` of a horizontal disc
/// of `flat_radius` whose centre lies `above` the tip, and all points above them.
struct SweptDisc {
    double flat_radius;    ///< mm
    double corner_radius;  ///< mm
    double above;          ///< mm
};

/// The moves first … last - 1 of a batch.
struct MoveRange {
    int first;
    int last;
};

/// Tests whether moves may lower the stock under `top`, and writes 1 or 0 per move to
/// `touches`. A 0 is certain, a 1 is not.
///
/// The swept volume of a move is convex. It does not touch the tile's piece of the plane
/// if a plane separates the two. The test tries one separating plane: the one
/// perpendicular to the line from the middle of the tile to the nearest point of the
/// swept disc.
/// \param range moves of the batch that are tested.
void may_touch(const UpperPlane& top, const MoveBatch& batch, const SweptDisc& disc,
               MoveRange range, std::uint8_t* touches);

}  // namespace endmill
