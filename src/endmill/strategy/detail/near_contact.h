// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// The contact at a share of the way between two contacts of a smooth surface, by the contacts
/// alone. The chord between them is raised by the curvature that their normals tell, so that
/// the error is of third order in their distance.
inline CutterContact near_contact(const CutterContact& from, const CutterContact& to,
                                  double share)
{
    const Vec3 way = to.point - from.point;
    const Vec3 turn = to.normal - from.normal;
    const Vec3 normal = (from.normal + share * turn).normalized();
    const double rise = share * (1 - share) / 2 * way.dot(turn);
    return {from.point + share * way + rise * normal, normal};
}

}  // namespace endmill
