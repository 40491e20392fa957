// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Core>

#include "endmill/core/vec.h"

namespace endmill {

/// A thick disc along a tangent plane of a surface: all points within `half_thickness` of
/// the plane and, along the plane, within `radius` of a centre.
///
/// Around a piece of a curved surface its thickness is about its width times the width
/// times the curvature. A box along the coordinate axes is much thicker where the surface
/// is oblique. A ball that touches the surface therefore misses all discs except the
/// nearest few.
struct TangentDisc {
    Vec3 centre = Vec3::Zero();   ///< mm
    Vec3 normal = Vec3::UnitZ();  ///< unit normal of the plane
    double radius = 0;            ///< mm
    double half_thickness = 0;    ///< mm

    /// Returns the squared distance from `place` in mm^2. It exceeds the true one by at
    /// most 1e-15 of the squared distance from the centre.
    double squared_distance(const Vec3& place) const
    {
        const Vec3 away = place - centre;
        const double over = away.dot(normal);
        const double up = std::max(std::abs(over) - half_thickness, 0.0);
        const double out = std::max((away - over * normal).norm() - radius, 0.0);
        return up * up + out * out;
    }

    /// Returns the disc, enlarged until it contains `place`.
    TangentDisc including(const Vec3& place) const
    {
        const Vec3 away = place - centre;
        const double over = std::abs(away.dot(normal));
        return {centre, normal, std::max(radius, away.norm()),
                std::max(half_thickness, over)};
    }

    /// Returns the disc, enlarged by `more` mm on all sides.
    TangentDisc expanded(double more) const
    {
        return {centre, normal, radius + more, half_thickness + more};
    }
};

/// Returns a disc of size 0 in the plane of a quadrilateral: its centre is the mean of
/// the corners, its normal is perpendicular to both diagonals; +z if the diagonals are
/// parallel.
/// \param corners in order around the quadrilateral, mm.
TangentDisc tangent_disc(std::span<const Vec3, 4> corners);

}  // namespace endmill
