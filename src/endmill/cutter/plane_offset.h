// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"

/// \file
/// Offsets of plane curves: of a sampled profile with its normals, and of a polyline.
///
/// Implemented in `plane_offset.cpp` and `polyline_offset.cpp`.

namespace endmill {

/// A point of a plane curve in the xz plane, with the normal there.
struct ProfilePoint {
    /// (x, z) in mm.
    Eigen::Vector2d point;
    Eigen::Vector2d normal;  ///< unit, out of the material, n_z > 0
};

/// Unit normal of a profile z = f(x) with slope f': (-f', 1) / sqrt(1 + f'^2).
/// Source: [JangKimJeong, eq. (1), (2)], corrected: the printed N = 1/f' is not the slope
/// of the normal, and the printed angle does not exist where f' = 0.
Eigen::Vector2d profile_normal(double slope);

/// The normal for a sampled crease of a profile. Its slope is the mean of the slopes
/// before and after the crease. The offset rounds a convex crease by two chords, and
/// folds at a concave one.
Eigen::Vector2d crease_normal(double slope_before, double slope_behind);

/// Unit normal of a parametric curve (x(t), z(t)): the `tangent` turned by 90 degrees to
/// the side with n_z > 0. For a vertical tangent it is the normal to its left.
/// \pre the tangent is not zero.
Eigen::Vector2d curve_normal(const Eigen::Vector2d& tangent);

/// The offset of a sampled profile for `cutter` in the plane of the profile: the
/// reference points
///
///     p + r n + (R - r) sgn(n_x) e_x.
///
/// Where the sign of n_x changes, there are two reference points, with the old and the
/// new sign. On a horizontal part of the profile the sign changes at the last point. The
/// step between the two points is 2 (R - r), forwards over a crest and backwards in a
/// valley. The offset of a flat-bottomed cutter therefore has a loop in every valley. A
/// ball has no such steps. A profile that is horizontal everywhere has no sign; its
/// offset is p + r n.
/// Source: [JangKimJeong, eq. (3)], whose +- is sgn(n_x).
/// \return at least one point for each point of the profile, in order.
std::vector<Eigen::Vector2d> plane_offset(const Cutter& cutter,
                                          std::span<const ProfilePoint> profile);

/// Options of polyline_offset.
struct PolylineOffsetOptions {
    /// Whether the cutter rolls around convex corners and around the ends of an open
    /// polyline. Without it, as in the paper, a chord replaces the arc at a convex corner,
    /// and the offset begins and ends at the normals of the first and the last segment.
    bool rolls_around_corners = true;
    /// Largest chord error in mm of an arc of the cutter's corner radius.
    double arc_tolerance = 1.25e-4;
};

/// The offset of a polyline, with its folds and loops.
struct PolylineOffset {
    /// (s, z) of the reference points in mm. Consecutive points are different; the last
    /// point of a closed polyline's offset repeats the first.
    std::vector<Eigen::Vector2d> points;
    /// Range of s in mm that the polyline and the offsets of its segments cover. Beyond it
    /// an open polyline's offset only rolls around the ends.
    double low_s;
    double high_s;  ///< mm
};

/// The offset of a polyline for `cutter` in the plane of the polyline. The tool is on the
/// left of the polyline. Each segment is offset by its own normal with plane_offset.
/// Around a convex corner the normal turns from one segment's to the next one's. At a
/// concave corner the offset folds; a chord joins the offsets of the two segments, which
/// lies where the corner is inside the cutter. For a ball, and with
/// `rolls_around_corners`, no point of the offset is farther than R from the polyline,
/// and the points whose distance is R, up to `arc_tolerance`, bound the region that the
/// centre may reach. Two segments that turn back on each other have a convex corner.
/// Source: [JangKimJeong, section II]; corners as in docs/methods/interference.md,
/// section 2.5.
/// \param polyline (s, z) in mm; closed if the last point equals the first.
/// \throws DomainError unless there are two points, consecutive points are different, all
///     are finite, and 0 < arc_tolerance.
/// \throws GeometryError if a segment has n_z < 0 and the cutter is not a ball: a flat
///     bottom cannot touch an overhang.
PolylineOffset polyline_offset(const Cutter& cutter,
                               std::span<const Eigen::Vector2d> polyline,
                               const PolylineOffsetOptions& options = {});

/// Upper estimate of the number of points of polyline_offset, without computing it.
double polyline_offset_size(const Cutter& cutter,
                            std::span<const Eigen::Vector2d> polyline,
                            const PolylineOffsetOptions& options = {});

}  // namespace endmill
