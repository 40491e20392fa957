// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "endmill/cutter/detail/sweep_entry.h"

namespace endmill {

/// `sweep_entry` for a bull-nose cutter: by half spaces, and where they do not tell by
/// tangents to S along the line, which is convex.
std::optional<SweepEntry> corner_entry(const StraightSweep& sweep, const Line& line,
                                       double before);

}  // namespace endmill
