// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "endmill/core/vec.h"

namespace endmill {

/// The corner of a polygon in space from which a fan of triangles covers it: seen along
/// the mean normal (the sum of corner_i x corner_i+1), no triangle of the fan is turned
/// over. That is so from every corner of a convex polygon, and from some corner of a
/// quadrangle; being out of plane does no harm as long as nothing folds.
///
/// Corners are tried in order and the first is taken from which all triangles have an
/// area; else the first from which the others have none (corners coincide or lie on a
/// line). Computed in double precision: it chooses diagonals and decides nothing else.
/// \return nothing if there is none among the first 100 corners, so that the time stays
/// in proportion to the polygon: it is far from convex, folded or crosses itself.
/// \pre at least 3 corners.
std::optional<std::size_t> fan_corner(std::span<const Vec3> polygon);

/// Largest distance of a corner from the plane through the mean of the corners across the
/// mean normal, in mm; 0 if there is no normal.
double out_of_plane(std::span<const Vec3> polygon);

}  // namespace endmill
