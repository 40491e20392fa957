// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

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

}  // namespace endmill
