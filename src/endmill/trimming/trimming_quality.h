// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/trimming.h"

namespace endmill {

/// How far a trimmed result is from the upper envelope of the curves that it comes from.
struct TrimmingQuality {
    double step_back_mm = 0;  ///< longest step back in s from point to point
    /// Largest depth of a point below the envelope, across the segment that it is on:
    /// (envelope(s) - z) |ds| / length, at both ends and the midpoint of every segment. At an
    /// end it is the envelope's limit from inside the segment that counts, so that a segment
    /// that begins at the foot of a step of the envelope is none below it.
    double gouge_mm = 0;
    /// Share of the s between the two ends of each open curve, taken together, over which
    /// nothing is left. Elsewhere only tails run, which a method may cut off.
    double uncovered = 0;
};

/// What a result may be off and still be called right.
struct TrimmingTolerance {
    double step_back_mm = 1e-12;  ///< rounding of coordinates of some 10 mm
    double gouge_mm = 0;
    double uncovered = 0;  ///< share
};

/// Judges `trimmed` by the segments of `curves` themselves: independent of all methods, the
/// exact ones too. For each segment of the result it looks at those over its ends and its
/// midpoint, which takes n log n steps for n segments unless many are long.
/// \pre the curves are as SectionCurve says and finite.
TrimmingQuality trimming_quality(std::span<const SectionCurve> curves,
                                 const Trimmed& trimmed);

/// Whether `quality` is within `tolerance`.
bool is_right(const TrimmingQuality& quality, const TrimmingTolerance& tolerance);

}  // namespace endmill
