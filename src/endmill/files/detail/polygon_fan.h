// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/core/vec.h"

namespace endmill {

/// The corner of a polygon in space from which a fan of triangles covers the polygon.
///
/// No triangle of the fan may be reversed when seen along the mean normal, the sum of
/// corner_i x corner_i+1. Every corner of a convex polygon and at least one corner of a
/// quadrangle satisfy this. The polygon need not be planar.
///
/// Corners are tried in order. The first corner whose triangles all have an area is
/// returned, else the first corner whose remaining triangles have no area (coincident or
/// collinear corners). Computed in double precision; the result only selects diagonals.
/// \return nothing if none of the first 100 corners qualifies: the polygon is far from
///         convex, folded or self-intersecting. The limit keeps the time linear in the
///         number of corners.
/// \pre at least 3 corners.
std::optional<std::size_t> fan_corner(std::span<const Vec3> polygon);

/// Largest distance of a corner from the plane through the mean of the corners across the
/// mean normal, in mm; 0 if the mean normal is zero.
double out_of_plane(std::span<const Vec3> polygon);

}  // namespace endmill
