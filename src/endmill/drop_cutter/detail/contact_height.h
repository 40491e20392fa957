// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// How high a cutter stands that is lowered onto one point q of a surface, and how that
/// changes over the surface:
///
///     z = q_z + r - profile(rho),   rho = |q_xy - axis|.
///
/// The cutter's height over the part is the greatest of all of its points.
/// Source: specification of the interference removal, section 6, R3.
struct ContactHeight {
    Vec3 point;                ///< q, mm
    double value;              ///< z of the reference point, mm
    Eigen::Vector2d gradient;  ///< of the value by u and v
    Eigen::Matrix2d hessian;
    double rim;                    ///< (rho^2 - R^2) / 2, mm^2: the bottom ends at 0
    Eigen::Vector2d rim_gradient;  ///< of `rim` by u and v
    Eigen::Matrix2d rim_hessian;
    Eigen::Vector2d slope;  ///< of the value by the axis' x and y, the point held
    Eigen::Vector2d pace;   ///< mm per unit of u and v
};

/// Of a point and its surface's partials there, under `cutter` with its `axis` in plan.
/// \return nothing where the point is not below the cutter: beyond its radius, and at it
///         unless it is flat.
std::optional<ContactHeight> contact_height(const SurfaceJet& jet, const Cutter& cutter,
                                            const Eigen::Vector2d& axis);

}  // namespace endmill
