// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/surface/surface.h"

namespace endmill {

/// Least and greatest value of r(u, v) . direction over the surface, in mm for a unit
/// `direction`: by branch and bound with the hull of the control points, never inside the
/// true extent's ends by more than 1e-9 of the surface's diagonal and 1e-14 of the value,
/// never outside.
Interval extent(const Surface& surface, const Vec3& direction);

/// The same over all `surfaces`.
/// \throws DomainError if there are none.
Interval extent(std::span<const Surface> surfaces, const Vec3& direction);

}  // namespace endmill
