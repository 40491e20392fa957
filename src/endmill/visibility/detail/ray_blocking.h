// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "endmill/core/vec.h"

namespace endmill {

/// Tests whether the ray from the centroid of `from` along `direction` meets the closed
/// triangle `facet`, from either side. A facet through the centroid itself blocks the
/// ray.
///
/// The answer is exact for the given doubles; the centroid (a + b + c) / 3 is not
/// rounded. The test takes about 20 ns if rounding errors cannot change a sign, else 50
/// us.
/// \param from corners, mm. \param direction not zero. \param facet corners, mm; it has
///         an area.
/// \pre all coordinates are finite.
bool blocks_ray(const std::array<Vec3, 3>& from, const Vec3& direction,
                const std::array<Vec3, 3>& facet);

}  // namespace endmill
