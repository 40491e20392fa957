// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/offset/drive_planes.h"
#include "endmill/trimming/cut_out.h"

namespace endmill {

// Views of section curves for tables and figures: numbers of points, a square window
// about a place, the curves as lines in space, and untrimmed curves in the form of a
// result.

/// Number of points of all `curves`.
std::size_t point_count(std::span<const SectionCurve> curves);
/// Number of points of all `curves`.
std::size_t point_count(std::span<const TrimmedCurve> curves);

/// The stretches of consecutive points of `curves` in the square |s - s_0| <= half_width,
/// |z - z_0| <= half_width about `centre`, in mm. Stretches of a single point are
/// dropped.
std::vector<SectionCurve> curves_near(std::span<const SectionCurve> curves,
                                      const SectionPoint& centre, double half_width);
/// The same for trimmed curves.
std::vector<TrimmedCurve> curves_near(std::span<const TrimmedCurve> curves,
                                      const SectionPoint& centre, double half_width);

/// The mean of the places of `cuts`. Empty if none has a place.
std::optional<SectionPoint> mean_place(std::span<const CutOut> cuts);

/// The curves as they are, in the form of a trimmed result. Its points are the vertices.
Trimmed untrimmed(std::span<const SectionCurve> curves);

/// The points of the curves in the plane t of `frame`, in mm.
std::vector<std::vector<Vec3>> lines_in_space(std::span<const TrimmedCurve> curves,
                                              const DriveFrame& frame, double t);

}  // namespace endmill
