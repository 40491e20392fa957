// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/core/tolerance.h"
#include "endmill/core/vec.h"

namespace endmill {

/// An end mill with a rounded corner: a flat bottom of radius R - r, a quarter torus of
/// radius r around it, and a cylinder of radius R above. r = R is the ball, r = 0 the flat
/// end mill. An immutable value. Shank and holder are no part of it.
class Cutter {
public:
    /// \param radius R in mm. \param corner_radius r in mm.
    /// \throws DomainError unless 0 < R is finite and 0 <= r <= R.
    Cutter(double radius, double corner_radius);

    static Cutter ball(double radius) { return {radius, radius}; }  ///< mm
    static Cutter flat(double radius) { return {radius, 0}; }       ///< mm

    double radius() const { return radius_; }                        ///< R, mm
    double corner_radius() const { return corner_radius_; }          ///< r, mm
    double flat_radius() const { return radius_ - corner_radius_; }  ///< R - r, mm
    bool is_ball() const { return corner_radius_ == radius_; }       ///< r = R
    bool is_flat() const { return corner_radius_ == 0; }             ///< r = 0

    /// Height in mm above the tip of the cutter's surface at `distance` from the axis:
    /// 0 up to R - r, then r - sqrt(r^2 - (distance - R + r)^2); infinite beyond R.
    /// Source: spec of the removal, section 1; a quarter circle.
    /// \pre distance >= 0. Relative error below 1e-15, also where the height is small.
    double profile(double distance) const;

    /// Whether both have the same radii.
    friend bool operator==(const Cutter&, const Cutter&) = default;

private:
    double radius_;
    double corner_radius_;
};

/// The word for `cutter` on the command line and in summaries: "ball:DIAMETER",
/// "flat:DIAMETER" or "bull:DIAMETER:CORNER_RADIUS", in mm.
std::string cutter_word(const Cutter& cutter);

/// The cutter that `word` spells.
/// \return nothing if it is no such word, or its numbers are out of range.
std::optional<Cutter> cutter_from_word(std::string_view word);

/// For messages: what is expected where `word` stands, from which `cutter_from_word` makes
/// no cutter. It is the number that is out of range, or how such a word is spelled.
std::string expected_cutter(std::string_view word);

/// Where the cutter touches the part.
struct CutterContact {
    Vec3 point;   ///< mm
    Vec3 normal;  ///< unit, out of the material
};

/// Where the machine puts the cutter.
struct CutterLocation {
    Vec3 tip;   ///< mm, the lowest point of the cutter on its axis
    Vec3 axis;  ///< unit, from the tip to the spindle
};

/// Ball-end mill: a half sphere under a cylinder of the same radius.
class BallCutter {
public:
    /// \param radius in mm.
    /// \throws DomainError unless radius is finite and positive.
    explicit BallCutter(double radius);

    double radius() const { return radius_; }  ///< mm

private:
    double radius_;
};

/// The location at which `cutter`, held along `axis`, touches `contact`: the ball's
/// centre lies one radius above the contact along the normal, whatever the axis.
/// Source: [KimChoi, section 3], r_cl = r + R (N - P).
///
/// \param axis P, unit, from the tip to the spindle.
/// \throws GeometryError if axis . normal <= 0: the shank would touch, not the ball.
CutterLocation locate(const BallCutter& cutter, const CutterContact& contact,
                      const Vec3& axis);

/// The point of a cutter that a position means.
enum class ControlPoint {
    Reference,  ///< on the axis at the height of the corner circle, r above the tip
    Tip,        ///< the lowest point on the axis
};

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
