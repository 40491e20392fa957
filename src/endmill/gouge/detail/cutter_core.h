// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// Half a space that holds all of a cutter's core.
struct SupportingPlane {
    Vec3 normal;      ///< unit, out of the core
    double distance;  ///< of the point asked about, positive outside, mm
};

/// What a cutter at a place is all that is within its corner radius r of: a ball's centre;
/// of others the cylinder of radius R - r that stands on the reference point, without end
/// upwards. The signed distance of a point from the cutter is that from its core less r,
/// inside too. The core is convex: its signed distance is the greatest of those from its
/// supporting planes.
class CutterCore {
public:
    /// \param reference in mm.
    CutterCore(const Cutter& cutter, const Vec3& reference);

    /// The supporting plane nearest to `point`: its distance is the core's.
    SupportingPlane nearest_plane(const Vec3& point) const;

    /// A bound of the distance of all points q from the core that have `normal` . q of at
    /// least `least` (mm): that of the supporting plane with that normal. Inside, where
    /// the planes of bottom and side count by themselves, of their mean that has it.
    /// \param normal unit, not upwards unless of a ball.
    double distance_beyond(const Vec3& normal, double least) const;

    /// The normal of a nearly flat piece of the part, turned away from the core as a
    /// supporting plane's is: bounds by that plane are near the piece's own distance also
    /// where the core has an edge.
    Vec3 turned_away(const Vec3& normal, const Vec3& point) const;

    /// Signed distance of `point` from the cutter, mm.
    double gap(const Vec3& point) const { return nearest_plane(point).distance - r_; }

    /// One of those that do not look upwards: what lies lower is farther from it.
    SupportingPlane nearest_plane_below(const Vec3& point) const;

    double corner_radius() const { return r_; }  ///< mm

private:
    Vec3 reference_;
    double flat_radius_;
    double r_;
    bool is_ball_;
};

/// The point of a triangle nearest to the cutter, or deepest in it.
struct TriangleGap {
    double gap;  ///< mm, signed; at most the resolution above the least
    Vec3 point;  ///< mm
};

/// Halves the triangle until the least gap is known to `resolution` mm, or known not to be
/// below `enough`, in mm.
TriangleGap triangle_gap(const CutterCore& core, const std::array<Vec3, 3>& corners,
                         double resolution, double enough);

}  // namespace endmill
