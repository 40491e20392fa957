// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Which runs forward in s are searched for a crossing with each other.
enum class RunPairs : std::uint8_t {
    Neighbours,  ///< each with the next one
    All          ///< each with all behind it, nearest first
};

/// Cuts the loops out of `chain` by its runs forward in s: where `search` finds a crossing
/// of two of them at which the path turns upwards (rule `valley`) the loop is cut out, and
/// the search begins anew. Then the ends, while a rule applies: E1 the curve ends on a run
/// backwards, which is cut off; E2 it begins on one; E3 the branch in front of the first
/// fold, or behind the last, is too short in s to meet the other, and is cut off with the
/// fold. Nothing else is cut.
/// \param dead_band in mm, see `dead_band`.
/// \return how many runs backwards are left.
int trim_guarded(SectionChain& chain, double dead_band, CrossingSearch* search,
                 const TrimmingOptions& options, RunPairs pairs);

}  // namespace endmill
