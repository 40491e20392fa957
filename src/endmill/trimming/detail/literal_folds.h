// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/trimming/detail/branches.h"

namespace endmill {

/// Cuts the loops out of `chain` as the paper prints it, errors included: by the signs of
/// dz from segment to segment. Where they read - + - + (rule P4) the first run and the
/// fourth, where they read + - + (P3) the first and the third are searched for a crossing,
/// and the search goes on there. Where none is found the part in front of or behind the
/// fold is cut off, whichever is shorter in s: good path too, if there is no loop. P3 is
/// left out if the options say so.
/// Source: [JangKimJeong, section IV].
/// \param dead_band in mm, see `dead_band`.
void trim_literally(SectionChain& chain, double dead_band, CrossingSearch* search,
                    const TrimmingOptions& options);

}  // namespace endmill
