// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Method `winding`: loops removed by how often the curves wind around a place, also where a
/// section is no graph over s.
///
/// The tool is on the left of every curve. Open curves are closed straight down from both
/// ends and below everything. The index of a place is 0 far above, -1 for each curve crossed
/// on the way from left to right, +1 from right to left; coincident pieces add up. Kept are
/// the faces of index >= 0 that are joined to the outer one through such faces; without an
/// open curve all of index >= 0, counted from -1 outside if the outermost curve runs
/// counter-clockwise. The result is the border of what is kept, over the intervals
/// between the ends of open curves, the closing lines left out.
///
/// Exact for all finite coordinates, as envelope_trimming is, and equal to it over those
/// intervals where what is kept has no overhang. Some 10 us a segment: an arrangement by
/// CGAL with exact constructions. Source: spec of the interference, section 6.
/// \param options are not heeded.
/// \throws DomainError if a coordinate is not finite; LimitError if the curves have 2^31 - 1
///         points or more.
Trimmed winding_trimming(std::span<const SectionCurve> curves,
                         const TrimmingOptions& options = {});

}  // namespace endmill
