// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/deviation/detail/part_tiles.h"

namespace endmill {

struct HalfSpace;

/// The rays of a tile with their thickness, as a structure of arrays, so that the
/// compiler processes several rays at once.
struct alignas(64) RayRows {
    using Row = std::array<double, most_tile_cells>;  ///< one number per ray

    /// Number of rays that are processed at a time to find a minimum or maximum.
    static constexpr int lanes = 8;

    std::array<Row, 3> point;   ///< x, y and z in mm
    std::array<Row, 3> normal;  ///< x, y and z, unit
    Row left;                   ///< thickness, mm
    Row cosine;                 ///< between machined surface and part; any sign
    Row sweep;                  ///< number of the sweep that made the surface; -1 if none
    /// Number of rays. The entries from there up to `padded` are copies of a ray with
    /// thickness minus infinity, so that no sweep shortens them.
    int count;

    /// `count` rounded up to a multiple of `lanes`.
    int padded() const { return (count + lanes - 1) / lanes * lanes; }
};

/// Returns the greatest of the first `count` numbers, at least 0. The numbers up to the
/// next multiple of `lanes` are included as well.
double greatest(const RayRows::Row& row, int count);

/// Returns the greatest thickness, at least 0, mm.
double longest_left(const RayRows& rows);

/// Computes the distance of each ray, extended by `margin` mm, from the half space, minus
/// `margin`; `spare` mm is added for rounding.
/// \param short_by receives the distances; below 0 a ray may reach the half space.
/// \return the smallest distance.
double shortfalls(const RayRows& rows, const HalfSpace& half, double margin, double spare,
                  RayRows::Row& short_by);

}  // namespace endmill
