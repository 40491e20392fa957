// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "endmill/surface/surface.h"

namespace endmill {

/// The sign that turns du x dv into the normal on the tool's side, the same for the whole
/// surface. For ToolSide::Up it is the sign of the surface's projected area along `axis`,
/// an integral that is computed exactly but for rounding, of patches with weights by
/// Gauss-Legendre quadrature of 30 by 30 points.
/// \param axis from the tip to the spindle, unit.
/// \return +1 or -1; +1 if the projected area vanishes.
double tool_side_sign(const Surface& surface, const Vec3& axis);

/// The same for each of `surfaces`.
std::vector<double> tool_side_signs(std::span<const Surface> surfaces, const Vec3& axis);

/// A place that a tool along `axis` cannot touch with its ball: there N . axis <= 0, or
/// the surface has no normal.
struct UnreachablePlace {
    SurfacePoint at;
    Vec3 point;              ///< mm
    double normal_dot_axis;  ///< of the unit normal; 0 where `singular`
    bool singular;           ///< the partials are parallel or one of them vanishes
};

/// Looks for an unreachable place by bounding w^3 (du x dv) . axis, a polynomial, on ever
/// smaller pieces of each patch; not by sampling, so that a narrow overhang is found.
/// On a collapsed edge the normal's limit counts.
/// \param side from tool_side_sign.
/// \return nothing only if N . axis > 0 everywhere, but for pieces narrower than 2^-14
///        of a patch, which are decided at their corners.
std::optional<UnreachablePlace> find_unreachable_place(const Surface& surface,
                                                       const Vec3& axis, double side);

/// \throws GeometryError with the place that find_unreachable_place finds, if any.
void require_reachable(const Surface& surface, const Vec3& axis, double side);

/// The same for each of `surfaces`; the error names the patch, from 0.
/// \param sides from tool_side_signs.
void require_reachable(std::span<const Surface> surfaces, const Vec3& axis,
                       std::span<const double> sides);

}  // namespace endmill
