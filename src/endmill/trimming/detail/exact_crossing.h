// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/offset/section_curve.h"

namespace endmill {

/// The line through two points of different s.
struct SectionLine {
    SectionPoint a;  ///< mm
    SectionPoint b;  ///< mm
};

// All functions of this header are exact for all finite doubles. The coordinates become
// integers in units of a common power of two, and every decision is the sign of a
// polynomial in these integers. A call takes about 1 us, and more where coordinates
// differ in size by hundreds of binary orders.

/// Whether the crossing of p and q lies above `line` (1), on it (0) or below it (-1).
/// \pre p and q are not parallel.
int exact_side(const SectionLine& line, const SectionLine& p, const SectionLine& q);

/// Whether p runs above q at s (1), meets q there (0), or runs below q (-1).
int exact_height_order(const SectionLine& p, const SectionLine& q, double s);

/// Whether p and q cross at an s larger than the given one (1), equal to it (0), or
/// smaller (-1).
/// \pre p and q are not parallel.
int exact_order(const SectionLine& p, const SectionLine& q, double s);

/// Whether p1 and q1 cross at a larger s than p2 and q2 (1), at the same s (0) or at a
/// smaller s (-1).
/// \pre neither pair is parallel.
int exact_order(const SectionLine& p1, const SectionLine& q1, const SectionLine& p2,
                const SectionLine& q2);

/// The crossing of p and q; each coordinate is the nearest double (ties to even).
/// \pre p and q are not parallel, and the exact coordinates are within the range of
///     double.
SectionPoint exact_crossing(const SectionLine& p, const SectionLine& q);

/// The height of `line` at s as the nearest double (ties to even).
/// \pre the exact height is within the range of double.
double exact_height(const SectionLine& line, double s);

}  // namespace endmill
