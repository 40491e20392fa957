// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Trims the curves of a plane by method 3, repaired: not only neighbouring runs forward in
/// s are searched for a crossing, but all pairs, nearest first, so that nested loops and
/// loops with a zigzag at a cusp are found. Heeds no option.
/// \throws DomainError on a curve that is not finite.
Trimmed trim_repaired(std::span<const SectionCurve> curves,
                      const TrimmingOptions& options);

}  // namespace endmill
