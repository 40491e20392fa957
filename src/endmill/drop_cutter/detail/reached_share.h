// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <utility>

#include "endmill/core/vec.h"

namespace endmill {

/// The stretch of a straight move, as shares from 0 to 1 of its length, on which a disc around
/// the moving point contains a point of a triangle, seen from above. It is one stretch because
/// the places from which the disc reaches the triangle form a convex set. The stretch is longer
/// than the exact one by the rounding error, and never shorter.
/// \param corners of the triangle, mm; their heights do not matter.
/// \param from start of the move, mm.
/// \param to end of the move, mm.
/// \param radius of the disc, mm.
/// \return nothing if the disc nowhere reaches the triangle.
std::optional<std::pair<double, double>> reached_share(const std::array<Vec3, 3>& corners,
                                                       const Eigen::Vector2d& from,
                                                       const Eigen::Vector2d& to,
                                                       double radius);

}  // namespace endmill
