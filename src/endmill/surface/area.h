// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// Area of the surface in mm^2, the integral of |du x dv|, by Gauss-Legendre quadrature
/// on pieces that are halved until a finer rule agrees. Relative error below 1e-9 where
/// the surface has a normal everywhere.
double area(const Surface& surface);

/// The sum of the areas in mm^2.
double area(std::span<const Surface> surfaces);

}  // namespace endmill
