// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/cutter.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

BallCutter::BallCutter(double radius) : radius_{radius}
{
    require(std::isfinite(radius) && radius > 0, "BallCutter: need 0 < radius");
}

CutterLocation locate(const BallCutter& cutter, const CutterContact& contact,
                      const Vec3& axis)
{
    if (axis.dot(contact.normal) <= 0)
        throw GeometryError{"locate: the contact is on or above the equator of the ball"};
    const Cutter ball = Cutter::ball(cutter.radius());
    return {control_point(ball, contact, ControlPoint::Tip, axis), axis};
}

}  // namespace endmill
