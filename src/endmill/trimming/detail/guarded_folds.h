// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// The pairs of runs forward in s that are searched for a crossing.
enum class RunPairs : std::uint8_t {
    Neighbours,  ///< each run with the next one
    All          ///< each run with all behind it, nearest first
};

/// Cuts the loops out of `chain`, by its maximal runs forward in s:
/// 1. If `find` returns a crossing of two runs at which the path turns upwards, the loop
///    between them is cut out (rule `valley`) and the search starts again.
/// 2. When no pair crosses, the end rules are applied until none fits. E1: the curve ends
///    on a backward run, which is cut off. E2: the curve begins on a backward run, which
///    is cut off. E3: the branch in front of the first fold, or behind the last one, is
///    too short in s to meet the other branch; it is cut off with the fold.
///
/// Nothing else is cut.
/// Source: docs/methods/interference.md, section 4.
/// \param chain the curve.
/// \param dead_band in mm, see dead_band().
/// \param find the search of the method, with guarded detection.
/// \param pairs the pairs of runs to search.
/// \return the number of backward runs that remain.
int trim_guarded(SectionChain& chain, double dead_band, const CrossingFinder& find,
                 RunPairs pairs);

}  // namespace endmill
