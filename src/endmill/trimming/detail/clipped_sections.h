// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/surface/surface_jet.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// What of `curves` lies within `range` of s, in mm, its ends included: so that a path
/// which the border's contacts raised stays over the part. A curve that leaves the range
/// and comes back becomes several, in their order; one that only touches it is left out.
/// New ends are TrimmedKind::End. A closed curve that is cut becomes open.
/// Source: specification of the interference removal, section 2.5.
std::vector<TrimmedCurve> clipped(const std::vector<TrimmedCurve>& curves,
                                  const Interval& range);

}  // namespace endmill
