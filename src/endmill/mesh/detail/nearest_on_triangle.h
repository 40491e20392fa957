// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"

namespace endmill {

/// The point of a triangle that is nearest to `place`, to 1e-14 of the largest coordinate
/// (mm) however thin the triangle is. Triangles with a common edge that is nearest find
/// the same point of it.
Vec3 nearest_on_triangle(const Vec3& place, const std::array<Vec3, 3>& corners);

}  // namespace endmill
