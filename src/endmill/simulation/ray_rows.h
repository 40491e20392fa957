// SPDX-License-Identifier: GPL-3.0-or-later
// Internal to simulation
#pragma once

#include <array>
#include <cstdint>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/simulation/part_tiles.h"

namespace endmill {

struct HalfSpace;

/// Rays of a tile side by side, so that the compiler does several at a time, and what is
/// left of each.
struct alignas(64) RayRows {
    using Row = std::array<double, most_tile_cells>;

    std::array<Row, 3> point;   ///< mm
    std::array<Row, 3> normal;  ///< unit
    Row left;                   ///< mm
    Row cosine;                 ///< of what is left against the part there; any sign
    Row sweep;                  ///< number of the sweep that made it, -1 if none
    int count;  ///< of rays; those up to the next multiple of 8 are copies
};

/// mm: what ends so near below a ray's point, as a cutter that just touches a wall, ends
/// there.
inline constexpr double touching = 1e-9;

/// The greatest `left`, or 0.
double longest_left(const RayRows& rows);

/// How far each ray, `margin` mm longer than what is left of it, falls short of the half
/// space less `margin` and a rounding of `spare` mm.
/// \return the least of them: below 0 some ray may reach what lies in the half space.
double shortfalls(const RayRows& rows, const HalfSpace& half, double margin, double spare,
                  RayRows::Row& short_by);

/// Shortens the rays by what a ball clears on a move: `mown` of each, several at a time.
/// \param short_by below 0 for the rays that the move may shorten.
void shorten_by_ball(RayRows& rows, const StraightSweep& sweep, std::int32_t number,
                     const RayRows::Row& short_by);

}  // namespace endmill
