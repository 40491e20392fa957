// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/core/angle.h"
#include "endmill/surface/surface.h"

namespace endmill {

/// The surfaces for which the bound has a closed form.
enum class ShapeKind {
    Plane,     ///< a part of a plane
    Sphere,    ///< a part of a sphere
    Cylinder,  ///< a part of a circular cylinder
};

/// A surface that is a part of a plane, a sphere or a circular cylinder.
struct SimpleShape {
    ShapeKind kind;  ///< which one
    double
        curvature;   ///< 1/mm, positive where convex: one over the radius; 0 for a plane
    double area;     ///< mm^2
    Angle steepest;  ///< greatest angle between the normal and +z
};

/// Recognises a plane, a sphere or a circular cylinder.
///
/// The distance of a patch of degrees p and q from the shape vanishes everywhere if it
/// vanishes at (2p + 1)(2q + 1) places on a grid, because its square times the squared
/// weight is a polynomial of degrees 2p and 2q. A surface is recognised if all these
/// places lie within 1e-9 of its diagonal from the shape, and the normals there point to
/// one side of it.
/// \param surface that does not overlap itself; not checked.
/// \param side from tool_side_sign.
/// \return nothing for other surfaces, and where a place has no normal.
std::optional<SimpleShape> simple_shape(const Surface& surface, double side);

}  // namespace endmill
