// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/stock/detail/dexel_cut.h"
#include "endmill/stock/detail/tool_pieces.h"
#include "endmill/stock/dexel_stock.h"

/// \file
/// The chords of the pieces of a motion with parallel rays of dexels.

namespace endmill {

/// Neighbouring parallel rays with their material.
struct DexelRays {
    double unit;                ///< mm
    Vec3 direction;             ///< unit, of all rays
    double length;              ///< mm, of all rays
    std::vector<Dexel> dexels;  ///< one per ray
    std::vector<Vec3> starts;   ///< mm, one per ray, in a plane across the rays
    Vec3 middle;                ///< mm, of the starts
    double radius;              ///< mm, greatest distance of a start from the middle
};

/// A stretch of a ray, mm from its start.
struct RayStretch {
    double from;
    double to;
};

/// A chord with the number of its ray.
struct RayChord {
    std::size_t ray;
    DexelChord chord;
};

/// Adds the chords of a piece with the material of the rays. Where the ends of a chord are in
/// doubt, the piece is halved, and there is a chord for each part of it.
/// Source: docs/methods/five-axis-removal.md, section 5.
/// \param material contains the material of all rays.
void add_chords(const DexelRays& rays, const ToolPiece& piece, const RayStretch& material,
                std::vector<RayChord>& chords);

/// Adds the chords of a piece with the material of one ray.
void add_chords_on_ray(const DexelRays& rays, const ToolPiece& piece, std::size_t ray,
                       std::vector<RayChord>& chords);

}  // namespace endmill
