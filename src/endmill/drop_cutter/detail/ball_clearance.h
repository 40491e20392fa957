// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"

namespace endmill {

/// Whether a ball on a straight move, with an upright cylinder of its radius above it, is
/// proved to be clear of a triangle. The proof is quick and succeeds for most small
/// triangles, also close to the ball. A ball whose centre is at least d from the plane of
/// the triangle meets the plane within sqrt(R^2 - d^2) of the foot of the centre. The move
/// is halved a few times until these circles are beside the triangle.
/// \param corners  of the triangle, mm.
/// \param from, to centres of the ball, mm.
/// \param radius   of the ball in mm, above 0.
/// \return true is certain to rounding errors; false means that nothing is proved.
bool is_ball_proved_clear(const std::array<Vec3, 3>& corners, const Vec3& from,
                          const Vec3& to, double radius);

}  // namespace endmill
