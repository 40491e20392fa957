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
    std::size_t number;  ///< of its surface, from 0
    const Surface* surface;
    Parameter along;    ///< that changes along the side
    int end;            ///< of the other parameter: 0 its lowest value, 1 its highest
    int patch;          ///< number of the patch in `along`
    SurfacePoint from;  ///< where it starts, with rising parameter
    SurfacePoint to;    ///< where it ends
    std::array<Vec3, 2> ends;  ///< mm

    /// The place at a share `t` of the side.
    SurfacePoint at(double t) const;

    /// Point and partials there.
    SurfaceTangents tangents(double t) const;
};

/// The sides of all patches on the borders of `surfaces`, which must outlive them. Sides
/// that are one point, to 1e-6 of the largest surface's diagonal, are left out.
std::vector<PatchSide> patch_sides(std::span<const Surface> surfaces);

/// Pairs of `sides`, by their numbers, whose ends are the same two points to `same_end`
/// mm, in either order, and between them lie beside each other; of very many sides at one
/// place, each with 8 others.
std::vector<std::pair<std::size_t, std::size_t>> meeting_sides(
    std::span<const PatchSide> sides, double same_end);

/// What counts as the same end, in mm: 1e-6 of the largest surface's diagonal.
double same_end_mm(std::span<const Surface> surfaces);

}  // namespace endmill
