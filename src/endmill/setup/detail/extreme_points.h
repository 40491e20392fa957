// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"

namespace endmill {

/// The vertices of the convex hull of some points, which contain the farthest point in
/// every direction. Exact for the given coordinates; points on one plane or line are
/// allowed. A few points are returned as they are, because a hull would not save work.
std::vector<Vec3> extreme_points(std::vector<Vec3> points);

}  // namespace endmill
