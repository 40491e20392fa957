// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_cut.h"

#include <cstddef>

namespace endmill {

std::int64_t remove_interval(std::vector<DexelInterval>& set, const DexelInterval& cut)
{
    std::int64_t removed = 0;
    for (std::size_t k = 0; k < set.size();) {
        DexelInterval& one = set[k];
        const DexelInterval both{std::max(one.from, cut.from), std::min(one.to, cut.to)};
        if (both.from >= both.to) {
            ++k;
            continue;
        }
        removed += std::int64_t{both.to} - both.from;
        const DexelInterval above{both.to, one.to};
        one.to = both.from;
        if (one.from < one.to) {
            ++k;
            if (above.from < above.to)
                set.insert(set.begin() + static_cast<std::ptrdiff_t>(k), above);
        } else if (above.from < above.to) {
            one = above;
        } else {
            set.erase(set.begin() + static_cast<std::ptrdiff_t>(k));
        }
    }
    return removed;
}

std::int64_t length_within(const std::vector<DexelInterval>& set,
                           const DexelInterval& within)
{
    std::int64_t sum = 0;
    for (const DexelInterval& one : set)
        sum += std::max(std::int64_t{0}, std::int64_t{std::min(one.to, within.to)} -
                                             std::max(one.from, within.from));
    return sum;
}

DexelCut cut_dexel(Dexel& dexel, const DexelChord& chord)
{
    DexelCut done;
    done.deepest = length_within(dexel.lower, chord.sure);
    done.most_deep = length_within(dexel.upper, chord.may);
    done.removed = remove_interval(dexel.lower, chord.may);
    done.removed += remove_interval(dexel.upper, chord.sure);
    return done;
}

}  // namespace endmill
