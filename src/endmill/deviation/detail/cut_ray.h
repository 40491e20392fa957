// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>

#include "endmill/core/tolerance.h"
#include "endmill/cutter/straight_sweep.h"
#include "endmill/deviation/part_charts.h"

namespace endmill {

/// Signed thickness of the material on one measuring ray.
///
/// A measuring ray starts on the part's surface and follows its normal. A move shortens
/// the ray to the part before the first point that lies in the swept volume.
struct CutRay {
    double thickness = 0;  ///< mm; > 0: material remains, < 0: depth of a gouge
    double slope = 0;  ///< tangent of the angle between the machined surface and the part
    /// Number of the sweep that made the surface; -1: the stock itself.
    std::int32_t sweep = -1;
};

/// Returns the material on a ray of the part before any move.
using InitialRay = std::function<CutRay(const PartRay&)>;

/// Returns the slope of a surface whose normal has this cosine with the part's normal;
/// the sign does not matter. It is infinite for 0.
double slope_of_cosine(double cosine);

/// Returns the ray after a single sweep: its thickness is the smallest t at which the
/// ray's line enters the swept volume.
///
/// The sweep counts only if it clears a point of the ray outside the part (t >= 0). A
/// volume that ends below the part's surface has removed material on another side of the
/// part. A volume that ends at the ray's point, within rounding, gives thickness 0.
/// \param before thickness before the sweep, mm.
/// \return nothing if the sweep does not shorten the ray below `before`.
std::optional<CutRay> cut_ray(const StraightSweep& sweep, const PartRay& ray,
                              double before = std::numeric_limits<double>::infinity());

}  // namespace endmill
