// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/core/vec.h"
#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// The points origin + t direction.
struct Line {
    Vec3 origin;     ///< mm
    Vec3 direction;  ///< unit
};

/// Where a line comes into the region that a move clears, the points above its S.
struct SweepEntry {
    double t;  ///< mm from the line's origin; minus infinity if it has always been inside
    Vec3 normal;  ///< there, unit, out of the region: into what the move leaves
};

/// The entry with the least t, if that is below `before` (mm), which makes a no come soon.
/// Exact but for rounding for a ball and a flat cutter, by lines, circles, cylinders and
/// spheres; of a bull-nose to 1e-12 of its size, by half spaces that hold the region.
/// \return nothing if the line misses the region, or enters it later.
std::optional<SweepEntry> sweep_entry(
    const StraightSweep& sweep, const Line& line,
    double before = std::numeric_limits<double>::infinity());

/// Whether the move clears `point`, or touches it.
inline bool clears(const StraightSweep& sweep, const Vec3& point)
{
    return sweep.height(point.x(), point.y()) <= point.z();
}

}  // namespace endmill
