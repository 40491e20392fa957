// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Method `envelope`: the upper envelope of all segments of all curves of a plane, vertical
/// ones included, over [min s, max s] of all their points: no method that trims a section
/// can give more for a tool that comes from above. Jumps become vertical links; where no
/// curve lies over an open interval the result breaks.
///
/// Exact for all finite coordinates: every decision is that of the true geometry of the given
/// points, and each coordinate of a crossing or link is the double nearest to the true one. A
/// vertical segment that stands alone over its s is a curve by itself, upwards.
/// Where segments coincide the one with the smallest number carries. Some 50 ns a segment.
/// Source: spec of the interference, sections 6 (R1) and 7.
/// Source: shared specification of interference, R1 of section 6, and section 7.
/// \param options are not heeded.
/// \throws DomainError if a coordinate is not finite; LimitError if the curves have 2^31 - 1
///         points or more.
Trimmed envelope_trimming(std::span<const SectionCurve> curves,
                          const TrimmingOptions& options = {});

}  // namespace endmill
