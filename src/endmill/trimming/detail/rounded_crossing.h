// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/exact_crossing.h"

namespace endmill {

/// The crossing of the segments p and q; each coordinate is the nearest double (ties to
/// even). It is computed in pairs of doubles, which takes about 20 ns. Where their error
/// bound leaves two candidates, exact_crossing decides. The bounds are proved in
/// paper/notes/envelope-filters.md.
/// \pre the segments have exactly one point in common.
SectionPoint rounded_crossing(const SectionLine& p, const SectionLine& q);

/// The height of the segment `line` at s as the nearest double (ties to even).
/// \pre s lies within the segment.
double rounded_height(const SectionLine& line, double s);

}  // namespace endmill
