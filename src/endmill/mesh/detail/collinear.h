// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

/// Whether three points lie on one line: exactly, of the coordinates as they stand, and
/// always if two of the points are equal. In double precision where that is sure, else
/// by sums of products without rounding.
/// Source of both: J. R. Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast
/// Robust Geometric Predicates, 1997, its filter of the predicate ORIENT2D and section 2.
/// \pre coordinates are 0 or between 1e-140 and 1e140 in size: beyond, products leave the
///      range of a double, and the answer may be wrong.
bool are_collinear(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace endmill
