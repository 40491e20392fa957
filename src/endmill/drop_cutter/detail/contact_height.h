// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include <Eigen/Core>

#include "endmill/cutter/cutter.h"
#include "endmill/surface/surface_jet.h"

namespace endmill {

/// The height of a cutter that is lowered onto one point q of a surface, with its
/// derivatives over the surface:
///
///     z = q_z + r - profile(rho),   rho = |q_xy - axis|.
///
/// The height of the cutter over the part is the largest over all points.
/// Source: docs/methods/interference.md, section 6 (R3).
struct ContactHeight {
    Vec3 point;                ///< q, mm
    double value;              ///< z of the reference point, mm
    Eigen::Vector2d gradient;  ///< of the value by u and v
    /// Second derivatives of the value by u and v.
    Eigen::Matrix2d hessian;
    double rim;  ///< (rho^2 - R^2) / 2 in mm^2; it is 0 at the rim of the cutter
    Eigen::Vector2d rim_gradient;  ///< of `rim` by u and v
    /// Second derivatives of `rim` by u and v.
    Eigen::Matrix2d rim_hessian;
    Eigen::Vector2d slope;  ///< of the value by x and y of the axis, with q fixed
    Eigen::Vector2d pace;   ///< lengths of the partials in mm per unit of u and v
};

/// The height of `cutter` on a point of a surface.
/// \param jet the point and the surface's partials there.
/// \param cutter the cutter.
/// \param axis x and y of its axis, mm.
/// \return nothing if the point is not below the cutter: beyond its radius, or at its
///     radius unless the cutter is flat.
std::optional<ContactHeight> contact_height(const SurfaceJet& jet, const Cutter& cutter,
                                            const Eigen::Vector2d& axis);

}  // namespace endmill
