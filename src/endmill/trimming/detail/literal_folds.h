// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Cuts the loops out of `chain` as the paper prints it, errors included. The folds are
/// found by the signs of dz from segment to segment:
/// 1. Where the signs read - + - + (rule P4) the first and the fourth run are searched
///    for a crossing. Where they read + - + (rule P3) the first and the third run are
///    searched.
/// 2. If there is a crossing, the loop is cut out, and the search continues at the
///    crossing.
/// 3. If there is none, the part in front of the fold or behind it is cut off, whichever
///    is shorter in s. This removes good path if there is no loop.
/// Source: [JangKimJeong, section IV]; docs/methods/interference.md, section 4.
/// \param chain the curve.
/// \param dead_band in mm, see dead_band().
/// \param find the search of the method.
/// \param patterns the patterns that count.
void trim_literally(SectionChain& chain, double dead_band, const CrossingFinder& find,
                    FoldPatterns patterns);

}  // namespace endmill
