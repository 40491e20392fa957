// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/offset/section_curve.h"

namespace endmill {

/// The line through two points of different s.
struct SectionLine {
    SectionPoint a;
    SectionPoint b;
};

// All of these are exact for all finite doubles: the coordinates become integers in units of
// a power of two that all of them are multiples of, and every decision is the sign of a
// polynomial in these. They cost about 1 us, and more where coordinates differ in size by
// hundreds of binary orders.

/// Whether the crossing of p and q lies above `line` (1), on it (0) or below (-1).
/// \pre p and q are not parallel.
int exact_side(const SectionLine& line, const SectionLine& p, const SectionLine& q);

/// Whether p runs above q at s (1), meets it there (0), or runs below (-1).
int exact_height_order(const SectionLine& p, const SectionLine& q, double s);

/// Whether p and q cross at a larger s than this (1), there (0), or before (-1).
/// \pre p and q are not parallel.
int exact_order(const SectionLine& p, const SectionLine& q, double s);

/// Whether p1 and q1 cross at a larger s than p2 and q2 (1), at the same (0) or at a
/// smaller (-1). \pre neither pair is parallel.
int exact_order(const SectionLine& p1, const SectionLine& q1, const SectionLine& p2,
                const SectionLine& q2);

/// The crossing of p and q, each coordinate the nearest double (ties to even).
/// \pre they are not parallel, and the crossing's coordinates are no larger than a double.
SectionPoint exact_crossing(const SectionLine& p, const SectionLine& q);

/// The height of `line` at s, the nearest double (ties to even).
/// \pre it is no larger than a double.
double exact_height(const SectionLine& line, double s);

}  // namespace endmill
