// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/trimming.h"

namespace endmill {

/// Trims the closed curves of a plane for the methods that search for crossings of
/// branches. A closed curve without a point above the upper envelope of the open curves
/// is dropped (rule `closed`). For any other closed curve its own upper envelope is kept,
/// as an open curve.
Trimmed trim_closed(std::span<const SectionCurve> curves);

}  // namespace endmill
