// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// Intervals between grid lines must be wider than this share of their range: else the
/// spline between them is all rounding.
inline constexpr double least_grid_interval = 1e-9;

/// The graph (u, v, z(u, v)) of the C2 bicubic spline that takes the heights of a grid,
/// with the not-a-knot condition at its four sides: what is between the first two
/// intervals of a line, and between the last two, is one cubic. Along a parameter with 3
/// or 2 grid lines it is quadratic or linear. u is x and v is y, in mm.
///
/// \param x rising, at least 2 of them, in mm.
/// \param y rising, at least 2 of them, in mm.
/// \param z in mm, x running fastest: z(x[i], y[j]) at [j * x.size() + i].
/// \throws DomainError if the sizes disagree, or x and y are not finite and rising by more
/// than `least_grid_interval`, or a height is not finite.
/// Polynomials up to bicubic are reproduced; heights to 1e-13 of the greatest where
/// neighbouring intervals differ by less than a factor of ten.
/// Source: tensor product of de Boor's not-a-knot spline.
Surface height_grid(std::span<const double> x, std::span<const double> y,
                    std::span<const double> z, ToolSide tool_side = ToolSide::Up);

}  // namespace endmill
