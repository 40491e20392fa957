// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// What a cutter along +z leaves below it on one straight move, as a height over the xy
/// plane: of the material it takes all that lies above S(x, y). The region above S is
/// convex. A move of no length, and one straight up or down, sweep the cutter at its lower
/// end. An immutable value.
///
/// S is exact but for rounding (1e-12 of the move's size and place): there are no
/// intermediate positions, so a move cut into pieces or run backwards leaves the same.
/// Source: the closed forms are those of a ball, disc and torus in oblique translation;
/// derived in paper/notes/swept-cutter.md.
class StraightSweep {
public:
    /// \param from, to tips in mm, finite.
    StraightSweep(const Cutter& cutter, const Vec3& from, const Vec3& to);

    const Cutter& cutter() const { return cutter_; }
    const Vec3& from() const { return from_; }  ///< tip, mm
    const Vec3& to() const { return to_; }      ///< tip, mm
    double length() const { return length_; }   ///< over the xy plane, mm
    double slope() const { return slope_; }     ///< rise over `length`; 0 if that is 0

    /// What touches S over a place.
    struct Height {
        double z;      ///< mm; infinite where the cutter does not pass over
        double along;  ///< how far the cutter has moved over the xy plane, mm
    };

    /// S at (x, y) and the position of the cutter that makes it.
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
    double direction_x_;  // of the move over the xy plane, unit
    double direction_y_;
};

}  // namespace endmill
