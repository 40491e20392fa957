// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"

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

}  // namespace endmill
