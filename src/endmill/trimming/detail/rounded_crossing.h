// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/exact_crossing.h"

namespace endmill {

/// The crossing of the segments p and q, each coordinate the nearest double (ties to even).
/// In pairs of doubles, some 20 ns, and by exact_crossing where these leave a doubt; the
/// bounds are proved in paper/notes/envelope-filters.md.
/// \pre the segments have just one point in common.
SectionPoint rounded_crossing(const SectionLine& p, const SectionLine& q);

/// The height of the segment `line` at s, the nearest double (ties to even).
/// \pre s lies within the segment.
double rounded_height(const SectionLine& line, double s);

}  // namespace endmill
