// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// A plane over a tile, nowhere below the heights of its cells.
struct TileTop {
    double x;  ///< mm, middle of the tile
    double y;
    double z;           ///< mm, of the plane there
    double slope_x;     ///< its rise along x
    double slope_y;     ///< along y
    double half_width;  ///< mm, from the middle to the outermost centres of cells
    double margin;      ///< mm, above the rounding of all that is computed here
};

/// The plane of the slope that fits the heights best, raised until it lies over all.
TileTop tile_top(HeightStock::ConstTile tile, const TilePlace& place);

/// A plane over all of the tiles that lie under `tops`, of their mean slope.
/// \pre there is a tile.
TileTop common_top(std::span<const TileTop> tops);

/// Moves side by side, for the loops that look at many: a structure of arrays.
struct MoveBatch {
    static constexpr int capacity = 256;

    std::array<double, capacity> x;  ///< mm, of the tip where the move begins
    std::array<double, capacity> y;
    std::array<double, capacity> z;
    std::array<double, capacity> dx;  ///< mm, to its end
    std::array<double, capacity> dy;
    std::array<double, capacity> dz;
    std::array<double, capacity> per_length2;  ///< 1 / |d|^2; 0 if it stays in place
    std::array<std::uint32_t, capacity> number;
    int count = 0;

    /// \pre count < capacity
    void add(const SweptMove& move, std::uint32_t its_number);

    /// Leaves only the moves with a 1, in their order.
    void keep(const std::uint8_t* kept);
};

/// The rounded disc that sweeps: the points within `corner_radius` of a disc of
/// `flat_radius`, whose centre lies `above` the tip, and all that is above them.
struct SweptDisc {
    double flat_radius;    ///< mm
    double corner_radius;  ///< mm
    double above;          ///< mm
};

/// Moves first … last - 1 of a batch.
struct MoveRange {
    int first;
    int last;
};

/// For the moves of a range of the batch: whether they may lower the stock under
/// `top`. A 0 is certain, a 1 is not. What a move sweeps is convex, so it is clear of the
/// tile's piece of the plane if a plane parts them; tried is the one across the line from
/// the middle of the tile to the nearest point of the disc near it.
void may_touch(const TileTop& top, const MoveBatch& batch, const SweptDisc& disc,
               MoveRange range, std::uint8_t* touches);

}  // namespace endmill
