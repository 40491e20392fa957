// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/deviation/detail/part_tiles.h"

namespace endmill {

struct HalfSpace;

/// Rays of a tile side by side, so that the compiler does several at a time, and what is
/// left of each.
struct alignas(64) RayRows {
    using Row = std::array<double, most_tile_cells>;

    /// That are done at a time where there is a least or a greatest to be found.
    static constexpr int lanes = 8;

    std::array<Row, 3> point;   ///< mm
    std::array<Row, 3> normal;  ///< unit
    Row left;                   ///< mm
    Row cosine;                 ///< of what is left against the part there; any sign
    Row sweep;                  ///< number of the sweep that made it, -1 if none
    int count;  ///< of rays; those after it, up to `padded`, are copies of one of them, of
                ///< which minus infinity is left, so that nothing shortens them

    int padded() const { return (count + lanes - 1) / lanes * lanes; }
};

/// The greatest of the first `count`, or 0. Those up to the next multiple of `lanes` are
/// looked at as well.
double greatest(const RayRows::Row& row, int count);

/// The greatest `left`, or 0.
double longest_left(const RayRows& rows);

/// How far each ray, `margin` mm longer than what is left of it, falls short of the half
/// space less `margin` and a rounding of `spare` mm.
/// \return the least of them: below 0 some ray may reach what lies in the half space.
double shortfalls(const RayRows& rows, const HalfSpace& half, double margin, double spare,
                  RayRows::Row& short_by);

}  // namespace endmill
