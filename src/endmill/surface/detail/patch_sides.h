// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// A side of a patch on the border of its surface.
struct PatchSide {
    std::size_t number;      ///< number of its surface, from 0
    const Surface* surface;  ///< its surface
    Parameter along;         ///< parameter that varies along the side
    int end;    ///< of the constant parameter: 0 at its lowest value, 1 at its highest
    int patch;  ///< number of the patch along `along`
    SurfacePoint from;         ///< start, where the parameter is lowest
    SurfacePoint to;           ///< end, where the parameter is highest
    std::array<Vec3, 2> ends;  ///< the points at `from` and `to`, mm

    /// The place at the share `t` of the side.
    SurfacePoint at(double t) const;

    /// Point and partial derivatives at the share `t`.
    SurfaceTangents tangents(double t) const;
};

/// The sides of all patches on the borders of `surfaces`, which must outlive the result.
/// A side that is a single point, up to 1e-6 of the largest surface's diagonal, is left
/// out.
std::vector<PatchSide> patch_sides(std::span<const Surface> surfaces);

/// The pairs of `sides`, by their numbers, that meet: their ends are the same two points
/// up to `same_end` mm, in either order, and they run beside each other in between. A
/// side is paired with at most 8 later ones.
std::vector<std::pair<std::size_t, std::size_t>> meeting_sides(
    std::span<const PatchSide> sides, double same_end);

/// Distance in mm up to which two ends are the same: 1e-6 of the largest surface's
/// diagonal.
double same_end_mm(std::span<const Surface> surfaces);

}  // namespace endmill
