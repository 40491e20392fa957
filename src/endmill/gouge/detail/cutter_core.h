// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// A half space that contains the core of a cutter.
struct SupportingPlane {
    Vec3 normal;      ///< unit, out of the core
    double distance;  ///< distance of the given point, positive outside, mm
};

/// The core of a cutter at a position: the set such that the cutter is everything within
/// its corner radius r of it. The core of a ball is its centre. The core of other cutters
/// is the cylinder of radius R - r on the reference point, without upper end. The signed
/// distance of a point from the cutter is that from the core minus r, inside the cutter
/// as well. The core is convex, so that its signed distance is the largest of the
/// distances from its supporting planes.
class CutterCore {
public:
    /// \param cutter the cutter.
    /// \param reference its reference point, mm.
    CutterCore(const Cutter& cutter, const Vec3& reference);

    /// The supporting plane that is nearest to `point`. Its distance is that of the core.
    SupportingPlane nearest_plane(const Vec3& point) const;

    /// A lower bound of the distance from the core of all points q with `normal` . q >=
    /// `least`: the distance of the supporting plane with that normal. Inside the core,
    /// where the planes of bottom and side count separately, it is divided by the sum of
    /// the normal's horizontal and vertical parts.
    /// \param normal unit, not upwards unless the cutter is a ball.
    /// \param least in mm.
    double distance_beyond(const Vec3& normal, double least) const;

    /// The unit normal of a nearly flat piece of the part, directed away from the core as
    /// the normal of a supporting plane is. Bounds by the plane with this normal are
    /// close to the piece's own distance, also where the core has an edge.
    /// \param normal of the piece, any length.
    /// \param point of the piece, mm.
    Vec3 turned_away(const Vec3& normal, const Vec3& point) const;

    /// Signed distance of `point` from the cutter, mm.
    double gap(const Vec3& point) const { return nearest_plane(point).distance - r_; }

    /// The nearest supporting plane among those that do not face upwards. Its distance
    /// does not decrease when the point moves down.
    SupportingPlane nearest_plane_below(const Vec3& point) const;

    double corner_radius() const { return r_; }  ///< mm

private:
    Vec3 reference_;
    double flat_radius_;
    double r_;
    bool is_ball_;
};

/// The point of a triangle that is nearest to the cutter, or deepest in it.
struct TriangleGap {
    double gap;  ///< mm, signed; at most the resolution above the exact value
    Vec3 point;  ///< mm
};

/// The gap between the cutter and a triangle, by halving the triangle until the gap is
/// known to `resolution` mm or known not to be below `enough`.
/// \param core the cutter.
/// \param corners of the triangle, mm.
/// \param resolution in mm.
/// \param enough in mm.
TriangleGap triangle_gap(const CutterCore& core, const std::array<Vec3, 3>& corners,
                         double resolution, double enough);

}  // namespace endmill
