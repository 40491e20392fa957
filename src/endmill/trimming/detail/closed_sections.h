// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/trimming.h"

namespace endmill {

/// What the methods that look for crossings of branches make of the closed curves of a
/// plane: one without a point above the upper envelope of the open ones is dropped (rule
/// `closed`); of another its own upper envelope is kept, as an open curve.
Trimmed trim_closed(std::span<const SectionCurve> curves, const TrimmingOptions& options);

}  // namespace endmill
