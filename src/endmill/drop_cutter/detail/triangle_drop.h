// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/drop_cutter/detail/triangle_contact.h"

namespace endmill {

/// Lowers a cutter over (x, y) onto a triangle. Its tip comes to rest at the largest q_z
/// - h(rho) of the triangle's points q with rho <= R, where rho is the distance of q from
/// the axis and h the profile of the cutter. The orientation of the triangle does not
/// matter. The expression is a concave function of q. Its maximum is therefore at the
/// touching point of the triangle's plane; if that is outside the triangle, it is on a
/// side that separates the two.
///
/// The tip is accurate to 1e-9 mm for coordinates within 1e4 mm and radii within 1e3 mm,
/// also at the rim of the cutter, where its profile is vertical, and on steep or thin
/// triangles. Where rounding errors of doubles could be larger, the computation is
/// repeated with twice the digits. A triangle without area is replaced by its sides.
/// Source: [JangKimJeong, eq. (3)] for the touching point of a plane.
class TriangleDrop {
public:
    /// \param cutter the cutter.
    explicit TriangleDrop(const Cutter& cutter);

    /// The cutter.
    const Cutter& cutter() const { return cutter_; }

    /// \param corners of the triangle, mm.
    /// \param x of the axis, mm.
    /// \param y of the axis, mm.
    /// \param least mm; a contact below it is of no interest, and any lower result may
    ///     replace it, also that of no contact.
    TriangleContact operator()(
        const std::array<Vec3, 3>& corners, double x, double y,
        double least = -std::numeric_limits<double>::infinity()) const;

private:
    Cutter cutter_;
};

/// The corner of a triangle on which a lowered ball rests highest.
struct HighestCorner {
    /// Number of the corner.
    int corner;
    double tip_z;  ///< height of the tip on that corner, mm
    /// upper bound of the tip on the whole triangle; equal to tip_z if the corner is
    /// touched
    double bound;
};

/// A quick test of the corners alone. The height is concave over the triangle. Its slopes
/// at the highest corner along the two sides, extended, bound it from above. If neither
/// slope is positive, the ball touches that corner.
///
/// Accurate to 1e-9 mm for coordinates within 1e4 mm and radii within 1e3 mm.
/// \param corners of the triangle, mm.
/// \param x of the ball's axis, mm.
/// \param y of the ball's axis, mm.
/// \param radius of the ball, mm.
/// \return nothing if all corners are beyond the ball or so near to its rim that rounding
///     errors matter.
inline std::optional<HighestCorner> highest_corner(const std::array<Vec3, 3>& corners,
                                                   double x, double y, double radius)
{
    // share of the radius; errors grow by its inverse
    constexpr double least_root = 1.0 / 16;
    std::array<Vec3, 3> local;
    std::array<double, 3> root;
    std::array<double, 3> height;
    for (int k = 0; k < 3; ++k) {
        local[k] = {corners[k].x() - x, corners[k].y() - y, corners[k].z()};
        root[k] = std::sqrt(std::max(
            radius * radius - (local[k].x() * local[k].x() + local[k].y() * local[k].y()),
            0.0));
        height[k] = local[k].z() + root[k];
    }
    const int other = height[1] > height[2] ? 1 : 2;
    const int highest = height[0] > height[other] ? 0 : other;
    if (!(root[highest] > least_root * radius))
        return std::nullopt;
    const Vec3& from = local[highest];
    double rise = 0;  // rise to another corner along the tangent, times the root
    for (int k = 1; k < 3; ++k) {
        const Vec3 side = local[(highest + k) % 3] - from;
        rise = std::max(
            rise, side.z() * root[highest] - (from.x() * side.x() + from.y() * side.y()));
    }
    const double tip = from.z() - (radius - root[highest]);
    return HighestCorner{highest, tip, rise > 0 ? tip + rise / root[highest] : tip};
}

}  // namespace endmill
