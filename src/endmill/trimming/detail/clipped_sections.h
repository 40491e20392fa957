// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/surface/surface_jet.h"
#include "endmill/trimming/trimming.h"

namespace endmill {

/// The pieces of `curves` over `range` of s, in mm, its ends included. Contacts on the
/// border raise the path beyond the part's end; clipping keeps the path over the part. A
/// curve that leaves the range and returns becomes several curves, in their order. A
/// curve that only touches the range is dropped. New ends have TrimmedKind::End. A
/// clipped closed curve becomes open.
/// Source: docs/methods/interference.md, section 2.5.
std::vector<TrimmedCurve> clipped(const std::vector<TrimmedCurve>& curves,
                                  const Interval& range);

}  // namespace endmill
