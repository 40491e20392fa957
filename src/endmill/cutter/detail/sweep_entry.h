// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>

#include "endmill/cutter/detail/line.h"

namespace endmill {

/// Where `line` first enters the region that the move of `sweep` clears: the points on or
/// above S.
///
/// Exact but for rounding for a ball and a flat cutter, from intersections with planes,
/// cylinders and spheres. Accurate to 1e-12 of the cutter's size for a bull-nose, by
/// `corner_entry`.
/// \param before in mm along the line; later entries are not reported, which saves time.
/// \return nothing if the line misses the region or enters it at or after `before`.
std::optional<SweepEntry> sweep_entry(
    const StraightSweep& sweep, const Line& line,
    double before = std::numeric_limits<double>::infinity());

/// Whether the move clears `point` or touches it.
inline bool clears(const StraightSweep& sweep, const Vec3& point)
{
    return sweep.height(point.x(), point.y()) <= point.z();
}

}  // namespace endmill
