// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// The surface that a cutter along +z leaves on one straight move, as a height S(x, y).
/// The move removes all material above S, and the region above S is convex. A move of
/// length 0, or straight up or down, removes the material that the cutter covers at the
/// lower end of the move. An immutable value.
///
/// S is exact except for rounding, about 1e-12 of the size and coordinates of the move.
/// It does not use intermediate positions of the cutter. A move that is divided into
/// several, or made backwards, therefore leaves the same surface.
/// Source: closed forms for a ball, a disc and a torus in oblique translation; derived in
/// paper/notes/swept-cutter.md, sections 1 to 6.
class StraightSweep {
public:
    /// \param cutter stands along +z.
    /// \param from tip at the start, in mm.
    /// \param to tip at the end, in mm.
    /// \throws DomainError if a coordinate is not finite.
    StraightSweep(const Cutter& cutter, const Vec3& from, const Vec3& to);

    /// As given.
    const Cutter& cutter() const { return cutter_; }
    const Vec3& from() const { return from_; }  ///< tip at the start, mm
    const Vec3& to() const { return to_; }      ///< tip at the end, mm
    double length() const { return length_; }   ///< horizontal length, mm
    double slope() const { return slope_; }  ///< rise per `length`; 0 if the length is 0

    /// A value of S, with the position of the cutter that leaves it.
    struct Height {
        double z;  ///< S in mm; infinite where the cutter does not pass
        /// Horizontal distance from the start of the move to that position, mm.
        double along;
    };

    /// S and the position of the cutter at (x, y), in mm.
    Height at(double x, double y) const;

    /// S at (x, y) in mm; infinite where the cutter does not pass.
    double height(double x, double y) const { return at(x, y).z; }

private:
    double corner_along(double s, double e2, double low, double high) const;

    Cutter cutter_;
    Vec3 from_;
    Vec3 to_;
    double length_;
    double slope_;
    double direction_x_;  // direction of the move over the xy plane, unit
    double direction_y_;
};

}  // namespace endmill
