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
/// minor radius r around it, and a cylinder of radius R above. A ball-end mill has r = R,
/// a flat end mill r = 0. An immutable value. Shank and holder are not part of it; see
/// `Tool`.
class Cutter {
public:
    /// \param radius R in mm.
    /// \param corner_radius r in mm.
    /// \throws DomainError unless R is finite, 0 < R and 0 <= r <= R.
    Cutter(double radius, double corner_radius);

    /// A ball-end mill. \param radius in mm.
    static Cutter ball(double radius) { return {radius, radius}; }
    /// A flat end mill. \param radius in mm.
    static Cutter flat(double radius) { return {radius, 0}; }

    double radius() const { return radius_; }                        ///< R, mm
    double corner_radius() const { return corner_radius_; }          ///< r, mm
    double flat_radius() const { return radius_ - corner_radius_; }  ///< R - r, mm
    bool is_ball() const { return corner_radius_ == radius_; }       ///< whether r = R
    bool is_flat() const { return corner_radius_ == 0; }             ///< whether r = 0

    /// Height in mm of the cutter's surface above the tip, at `distance` mm from the
    /// axis: 0 up to R - r, then r - sqrt(r^2 - (distance - R + r)^2), and infinity
    /// beyond R. The relative error is below 1e-15, also where the height is small.
    /// Source: docs/methods/removal.md, section 1.
    /// \pre distance >= 0.
    double profile(double distance) const;

    /// Whether both cutters have the same radii.
    friend bool operator==(const Cutter&, const Cutter&) = default;

private:
    double radius_;
    double corner_radius_;
};

/// The word for `cutter` on the command line and in summaries: "ball:DIAMETER",
/// "flat:DIAMETER" or "bull:DIAMETER:CORNER_RADIUS", in mm.
std::string cutter_word(const Cutter& cutter);

/// The cutter that `word` describes.
/// \return nothing if `word` has another form or its numbers are out of range.
std::optional<Cutter> cutter_from_word(std::string_view word);

/// Text for a message about a `word` that `cutter_from_word` could not read: the allowed
/// range if a number is out of range, the word without units if it has units, or else the
/// form of a cutter word.
std::string expected_cutter(std::string_view word);

/// The point at which the cutter touches the part, with the normal there.
struct CutterContact {
    Vec3 point;   ///< mm
    Vec3 normal;  ///< unit, out of the material
};

/// The position of the cutter: its tip and its axis.
struct CutterLocation {
    Vec3 tip;   ///< mm, the lowest point of the cutter on its axis
    Vec3 axis;  ///< unit, from the tip to the spindle
};

/// A ball-end mill: a half sphere under a cylinder of the same radius. Planners that
/// support no other cutter take this type.
class BallCutter {
public:
    /// \param radius in mm.
    /// \throws DomainError unless the radius is finite and positive.
    explicit BallCutter(double radius);

    double radius() const { return radius_; }  ///< mm

private:
    double radius_;
};

/// The location at which `cutter`, held along `axis`, touches the part in `contact`. The
/// centre of the ball lies one radius from the contact along the normal, for any axis.
/// Source: [KimChoi, section 3], r_cl = r + R (N - P).
/// \param cutter of radius R.
/// \param contact point r and unit normal N.
/// \param axis P, unit, from the tip to the spindle.
/// \throws GeometryError if axis . normal <= 0: the shank would touch instead of the
///         ball.
CutterLocation locate(const BallCutter& cutter, const CutterContact& contact,
                      const Vec3& axis);

/// The point of the cutter that a position refers to.
enum class ControlPoint {
    Reference,  ///< on the axis at the height of the corner circle, r above the tip
    Tip,        ///< the lowest point on the axis
};

/// Whether the tangent plane with the unit normal `normal` is perpendicular to `axis`. A
/// cutter with a flat bottom then touches with a whole disc: each p + r N + (R - r) D,
/// with |D| <= 1 perpendicular to the axis, is a reference point for the contact p.
inline bool is_level(const Vec3& normal, const Vec3& axis = Vec3::UnitZ())
{
    return (normal - normal.dot(axis) * axis).squaredNorm() <=
           level_normal * level_normal;
}

/// The vector from the contact to the control point, in mm. For the reference point it is
///
///     r N + (R - r) H,
///
/// and for the tip r P less. N is the unit `normal` of the contact, P the `axis`, and H
/// the unit direction of the component of N perpendicular to P. If `is_level` holds, H is
/// set to 0, which gives the centre of the disc. The formula holds for all cutters. For a
/// ball R - r = 0, so that H is not needed.
/// Source: [JangKimJeong, eq. (3)], with the sign for the side away from the material.
/// \param cutter with radius R and corner radius r.
/// \param normal unit, out of the material.
/// \param which the control point.
/// \param axis unit, from the tip to the spindle.
/// \pre normal . axis >= 0; otherwise the shank would touch.
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

/// The control point of `cutter`, held along `axis`, where it touches the part in
/// `contact`; see `control_offset`. Accurate to a few roundings of the coordinates.
inline Vec3 control_point(const Cutter& cutter, const CutterContact& contact,
                          ControlPoint which = ControlPoint::Reference,
                          const Vec3& axis = Vec3::UnitZ())
{
    return contact.point + control_offset(cutter, contact.normal, which, axis);
}

/// The cutter with both radii larger by `allowance` mm. Where it touches the part,
/// `cutter` at the same reference point leaves `allowance` mm of stock.
/// \throws DomainError unless the allowance is finite and not negative.
Cutter with_allowance(const Cutter& cutter, double allowance);

}  // namespace endmill
