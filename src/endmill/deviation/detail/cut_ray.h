// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>

#include "endmill/cutter/straight_sweep.h"
#include "endmill/deviation/detail/part_cell.h"

namespace endmill {

/// A ray of the part, shortened to what the moves leave of it.
struct MownRay {
    double left = 0;   ///< mm along the normal: material left, or if negative taken away
    double slope = 0;  ///< of what is left against the part there: tangent of the angle
    std::int32_t sweep = -1;  ///< the sweep that made it; none if the stock's own surface
};

/// mm: what ends so near below a ray's point, as a cutter that just touches a wall, ends
/// there.
inline constexpr double touching = 1e-9;

/// The slope of what makes an angle of this cosine, of either sign, with the part's normal;
/// infinite for 0.
double slope_of_cosine(double cosine);

/// What one sweep leaves of a ray, were it the only one: up to the least t at
/// which the region that it clears is entered, if some point of it outside the part is
/// (t >= 0); a region that ends below the part's surface has taken something on another
/// side of the part. A region that ends
/// at the ray's point, but for rounding, leaves nothing.
/// \return nothing if it leaves `before` mm or more.
std::optional<MownRay> mown(const StraightSweep& sweep, const PartRay& ray,
                            double before = std::numeric_limits<double>::infinity());

}  // namespace endmill
