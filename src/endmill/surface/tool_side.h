// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// The sign that turns du x dv into the normal on the tool's side, for the whole surface.
/// For ToolSide::Up it is the sign of the surface's projected area along `axis`. The
/// projected area is an exact integral, up to rounding. For patches with weights it is
/// computed by Gauss-Legendre quadrature with 30 by 30 points.
/// \param surface with its tool side.
/// \param axis from the tip to the spindle, unit.
/// \return +1 or -1; +1 if the projected area is zero.
double tool_side_sign(const Surface& surface, const Vec3& axis);

/// The sign for each of `surfaces`.
std::vector<double> tool_side_signs(std::span<const Surface> surfaces, const Vec3& axis);

/// A place that a ball-end mill along `axis` cannot touch: N . axis <= 0 there, or the
/// surface has no normal.
struct UnreachablePlace {
    SurfacePoint at;  ///< parameters
    Vec3 point;       ///< mm
    /// Product of the unit normal and the axis; nothing where the surface has no normal.
    std::optional<double> normal_dot_axis;
};

/// Searches for an unreachable place by bounds of the polynomial w^3 (du x dv) . axis on
/// smaller and smaller pieces of each patch, where w is the weight function of the patch
/// (1 without weights). It does not sample, so that it also finds a narrow overhang. On a
/// collapsed edge, the limit of the normal counts.
/// \param surface to search.
/// \param axis from the tip to the spindle, unit.
/// \param side from tool_side_sign.
/// \return If nothing is returned, N . axis > 0 everywhere. Pieces narrower than 2^-14 of
///         a patch are tested only at their corners.
std::optional<UnreachablePlace> find_unreachable_place(const Surface& surface,
                                                       const Vec3& axis, double side);

/// Checks that the surface has no unreachable place.
/// \throws GeometryError with the place that find_unreachable_place returns.
void require_reachable(const Surface& surface, const Vec3& axis, double side);

/// Checks each of `surfaces`; the error names the surface, from 0.
/// \param surfaces of the part.
/// \param axis from the tip to the spindle, unit.
/// \param sides from tool_side_signs.
void require_reachable(std::span<const Surface> surfaces, const Vec3& axis,
                       std::span<const double> sides);

}  // namespace endmill
