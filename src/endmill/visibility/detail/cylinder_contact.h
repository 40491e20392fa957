// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"

namespace endmill {

/// A closed solid cylinder with flat ends.
struct SolidCylinder {
    Vec3 start;     ///< mm: point of the axis at which heights are 0
    Vec3 axis;      ///< unit
    double radius;  ///< mm
    double from;    ///< mm: height of the lower end
    double to;      ///< mm: height of the upper end
};

/// Tests whether a closed triangle meets the cylinder. The triangle is cut at the heights
/// of both ends; the rest meets the cylinder if its projection along the axis comes
/// within the radius. The answer is right except for distances within 1e-14 of the
/// largest coordinate.
/// \param cylinder closed. \param corners of the triangle, mm.
bool meets(const SolidCylinder& cylinder, const std::array<Vec3, 3>& corners);

/// Tests whether a box may meet the cylinder. The answer is never false if the box meets
/// it.
/// \param cylinder closed. \param low, high corners of the box, mm.
bool may_meet(const SolidCylinder& cylinder, const Vec3& low, const Vec3& high);

}  // namespace endmill
