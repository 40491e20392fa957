// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Core>

#include "endmill/core/vec.h"

namespace endmill {

/// A round flat box: what lies within `half_thickness` of a plane and, along it, within
/// `radius` of a place. Around a piece of a surface it is thinner, by its own width times
/// the curvature, than any box along the axes can be where the surface is oblique; so that
/// a ball which touches the surface stays clear of all slabs but the nearest few.
struct Slab {
    Vec3 centre = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::UnitZ();  ///< of the plane, unit
    double radius = 0;            ///< mm
    double half_thickness = 0;    ///< mm

    /// Square of the distance from `place`, in mm^2; not more, but for a relative rounding
    /// of 1e-15 of that of the centre.
    double squared_distance(const Vec3& place) const
    {
        const Vec3 away = place - centre;
        const double over = away.dot(normal);
        const double up = std::max(std::abs(over) - half_thickness, 0.0);
        const double out = std::max((away - over * normal).norm() - radius, 0.0);
        return up * up + out * out;
    }

    /// The slab, wide and thick enough to hold `place` too.
    Slab reaching(const Vec3& place) const
    {
        const Vec3 away = place - centre;
        const double over = std::abs(away.dot(normal));
        return {centre, normal, std::max(radius, away.norm()),
                std::max(half_thickness, over)};
    }

    /// The same slab with `more` mm around it.
    Slab widened(double more) const
    {
        return {centre, normal, radius + more, half_thickness + more};
    }
};

/// A plane along a quadrilateral: through the mean of its corners, which run around it,
/// square to the normal of its diagonals. A slab of no size; any direction serves where
/// there is no normal.
Slab middle_of(std::span<const Vec3, 4> corners);

}  // namespace endmill
