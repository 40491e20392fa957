// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"

namespace endmill {

/// A solid cylinder about a line, its ends flat and part of it.
struct SolidCylinder {
    Vec3 start;     ///< mm: the line's point from which heights count
    Vec3 axis;      ///< unit
    double radius;  ///< mm
    double from;    ///< mm along the axis
    double to;      ///< mm along the axis
};

/// Whether a triangle, its edges and corners included, meets the cylinder: what of it lies
/// between the ends, seen along the axis, comes as near to it as the radius. Right but where
/// they touch within 1e-14 of the largest coordinate in play.
bool meets(const SolidCylinder& cylinder, const std::array<Vec3, 3>& corners);

/// Whether the box between two corners might meet the cylinder; never false if it does.
bool may_meet(const SolidCylinder& cylinder, const Vec3& low, const Vec3& high);

}  // namespace endmill
