// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "endmill/cutter/ball_cutter.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {

/// Diameters in mm of the balls to choose from, the largest first.
inline constexpr std::array<double, 8> stock_diameters{20, 15, 10, 6, 4, 3, 2, 1};

/// Whether `ball` is smaller than the largest that fits, of which there may be none.
bool fits(const BallCutter& ball, const std::optional<CutterLimit>& limit);

/// Diameter in mm of the largest ball of `stock_diameters` that fits.
/// \return nothing if none does.
std::optional<double> default_diameter(const std::optional<CutterLimit>& limit);

/// Tolerance and scallop height in mm of a verified plan: what a finished surface is usually
/// asked for.
inline constexpr double verified_tolerance = 0.01;

/// Chord tolerance and scallop height in mm for `ball` as the paper chooses them: a
/// thirtieth of its diameter, as 0.5 mm with a ball of 15 mm in [KimChoi, fig. 12].
double default_tolerance(const BallCutter& ball);

/// Height in mm along `axis`, a unit vector, at which the cutter moves freely: 5 mm above
/// the highest point of the surfaces, to within 1e-9 of their diagonals.
double default_safe_height(std::span<const Surface> surfaces, const Vec3& axis);

}  // namespace endmill
