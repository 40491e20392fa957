// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"

namespace endmill {

/// A point (x, z) of a plane curve and its unit normal there, in mm.
struct ProfilePoint {
    Eigen::Vector2d point;
    Eigen::Vector2d normal;  ///< away from the material, n_z > 0
};

/// Unit normal of a profile z = f(x) of slope f': (-f', 1) / sqrt(1 + f'^2).
/// Source: [JangKimJeong, eq. (1), (2)], corrected: the print's N = 1/f' is not the slope of the
/// normal, and its angle does not exist where f' = 0.
Eigen::Vector2d profile_normal(double slope);

/// The normal to take at a sampled crease of a profile: that of the mean of the slopes
/// before and behind it. A convex gap is so closed by two chords; a concave one folds.
Eigen::Vector2d crease_normal(double slope_before, double slope_behind);

/// Unit normal of a parametric curve (x(t), z(t)): its `tangent` turned by 90 degrees to
/// the side of n_z > 0; of a vertical tangent the side to its left.
/// \pre tangent is not zero.
Eigen::Vector2d curve_normal(const Eigen::Vector2d& tangent);

/// The offset of a sampled profile for `cutter` in its own plane: the reference points
///
///     p + r n + (R - r) sgn(n_x) e_x,
///
/// two of them, of the sign before and of the sign behind, where that changes; on a level
/// stretch it changes at the end. A ball has no such steps. Over a crest the step goes
/// forwards by 2 (R - r), in a valley backwards, so that a cutter with a flat bottom gets
/// a loop in every valley. A profile that is level all along has no sign: there p + r n.
/// Source: [JangKimJeong, eq. (3)]; its +- is sgn(n_x).
/// \return at least one point a point of the profile, in order.
std::vector<Eigen::Vector2d> plane_offset(const Cutter& cutter,
                                          std::span<const ProfilePoint> profile);

}  // namespace endmill
