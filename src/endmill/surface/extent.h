// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/surface.h"

/// \file
/// Extent and area of surfaces. Implemented in `extent.cpp` and `area.cpp`.

namespace endmill {

/// Least and greatest value of r(u, v) . direction over a surface, in mm for a unit
/// `direction`. Computed by branch and bound with the convex hull of the control points.
/// Each end lies inside the true extent by at most 1e-9 of the surface's diagonal plus
/// 1e-14 of its value, and never outside.
Interval extent(const Surface& surface, const Vec3& direction);

/// The extent of several surfaces together.
/// \throws DomainError if there are none.
Interval extent(std::span<const Surface> surfaces, const Vec3& direction);

/// Area of a surface in mm^2: the integral of |du x dv|, by Gauss-Legendre quadrature on
/// pieces that are halved until a finer rule agrees. The relative error is below 1e-9 if
/// the surface has a normal everywhere.
double area(const Surface& surface);

/// Sum of the areas in mm^2.
double area(std::span<const Surface> surfaces);

}  // namespace endmill
