// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "endmill/stock/dexel_stock.h"

namespace endmill {

/// What a move removes on a ray, in units: at most `may`, and all of `sure`.
struct DexelChord {
    DexelInterval may;
    DexelInterval sure;  ///< empty if from >= to
};

/// What a move does to the material on some rays, in units.
struct DexelCut {
    std::int64_t removed = 0;    ///< of the upper and of the lower set together
    std::int64_t deepest = 0;    ///< greatest length removed for certain on a ray
    std::int64_t most_deep = 0;  ///< greatest length that may be removed on a ray

    /// Adds what the move does on other rays.
    void add(const DexelCut& other)
    {
        removed += other.removed;
        deepest = std::max(deepest, other.deepest);
        most_deep = std::max(most_deep, other.most_deep);
    }
};

/// Removes an interval from a set. \return the length that was removed, in units.
std::int64_t remove_interval(std::vector<DexelInterval>& set, const DexelInterval& cut);

/// Returns the length of a set within an interval, in units.
std::int64_t length_within(const std::vector<DexelInterval>& set,
                           const DexelInterval& within);

/// Removes a chord from both sets of a ray: from the upper set what is removed for certain,
/// from the lower set all that may be removed.
DexelCut cut_dexel(Dexel& dexel, const DexelChord& chord);

}  // namespace endmill
