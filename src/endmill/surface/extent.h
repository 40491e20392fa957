// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// Least and greatest value of r(u, v) . direction over the surface, in mm for a unit
/// `direction`: by branch and bound with the hull of the control points, never inside the
/// true extent's ends by more than 1e-9 of the surface's diagonal and 1e-14 of the value,
/// never outside.
Interval extent(const Surface& surface, const Vec3& direction);

/// The same over all `surfaces`.
/// \throws DomainError if there are none.
Interval extent(std::span<const Surface> surfaces, const Vec3& direction);

/// Area of the surface in mm^2, the integral of |du x dv|, by Gauss-Legendre quadrature
/// on pieces that are halved until a finer rule agrees. Relative error below 1e-9 where
/// the surface has a normal everywhere.
double area(const Surface& surface);

/// The sum of the areas in mm^2.
double area(std::span<const Surface> surfaces);

}  // namespace endmill
