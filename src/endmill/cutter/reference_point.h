// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/core/vec.h"
#include "endmill/cutter/ball_cutter.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// The point of a cutter that a position means.
enum class ControlPoint {
    Reference,  ///< on the axis at the height of the corner circle, r above the tip
    Tip,        ///< the lowest point on the axis
};

/// Length of the part of a unit normal across the axis, up to which the normal counts as
/// parallel to it: above the rounding of a normal, and far below what any sampling sees.
inline constexpr double level_normal = 1e-12;

/// Whether the tangent plane with unit `normal` lies across `axis`. A cutter with a flat
/// bottom then touches with a whole disc: every p + r N + (R - r) D with |D| <= 1 across
/// the axis is a reference point of it.
inline bool is_level(const Vec3& normal, const Vec3& axis = Vec3::UnitZ())
{
    return (normal - normal.dot(axis) * axis).squaredNorm() <=
           level_normal * level_normal;
}

/// From the contact to the control point, in mm:
///
///     r N + (R - r) H  to the reference point, and less r P to the tip,
///
/// N the unit `normal` of the contact, P the `axis`, H the unit direction of N across P;
/// where `is_level`, 0 for H: the middle of the disc. One formula for all cutters; for a
/// ball, r = R, H is not looked at.
/// Source: [JangKimJeong, eq. (3)], whose sign is that of the side away from the material.
/// \param axis unit, from the tip to the spindle.
/// \pre normal . axis >= 0: below, the shank would touch.
inline Vec3 control_offset(const Cutter& cutter, const Vec3& normal,
                           ControlPoint which = ControlPoint::Reference,
                           const Vec3& axis = Vec3::UnitZ())
{
    const double r = cutter.corner_radius();
    Vec3 round =
        which == ControlPoint::Tip ? Vec3{r * (normal - axis)} : Vec3{r * normal};
    if (cutter.is_ball())
        return round;
    const Vec3 across = normal - normal.dot(axis) * axis;
    const double length2 = across.squaredNorm();
    if (length2 <= level_normal * level_normal)
        return round;
    round += (cutter.flat_radius() / std::sqrt(length2)) * across;
    return round;
}

/// The control point of `cutter`, held along `axis`, where it touches `contact`: see
/// `control_offset`. A few roundings of the coordinates.
inline Vec3 control_point(const Cutter& cutter, const CutterContact& contact,
                          ControlPoint which = ControlPoint::Reference,
                          const Vec3& axis = Vec3::UnitZ())
{
    return contact.point + control_offset(cutter, contact.normal, which, axis);
}

/// The cutter whose contacts leave `allowance` mm of stock: both radii larger by it. Its
/// reference points are those of `cutter` at that distance from the part.
/// \throws DomainError unless 0 <= allowance is finite.
Cutter with_allowance(const Cutter& cutter, double allowance);

}  // namespace endmill
