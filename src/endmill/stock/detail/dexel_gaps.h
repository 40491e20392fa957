// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/stock/detail/dexel_cut.h"
#include "endmill/stock/detail/fixed_axis_ball.h"
#include "endmill/stock/dexel_stock.h"

namespace endmill {

/// The gaps between two intervals of one set on eight rays, in units. Below each gap is
/// material from `below` to `from`, above it from `to` to `above`; both may be empty.
struct EightGaps {
    alignas(32) EightWhole below;
    alignas(32) EightWhole from;
    alignas(32) EightWhole to;
    alignas(32) EightWhole above;
};

/// The gaps of both sets on eight rays.
struct RowGaps {
    EightGaps upper;
    EightGaps lower;
};

/// The material of the rays of a tile while fixed-axis moves cut them.
///
/// Neighbouring moves remove overlapping intervals. Each ray therefore keeps the gap that it
/// was cut in last; a chord that only widens this gap changes two numbers, on eight rays at
/// once. Other chords go through the sets of intervals.
class DexelGaps {
public:
    /// \param columns number of rays in a row, at most eight.
    /// \param units length of the rays.
    DexelGaps(std::size_t columns, std::size_t rows, std::int32_t units);

    /// Whether no ray has material within an interval, by the gaps; yes if it is empty.
    bool contains(const DexelInterval& within) const
    {
        return within.from >= within.to ||
               (common_.from <= within.from && within.to <= common_.to);
    }

    /// Removes the chords of all rows.
    /// \param dexels row by row, always the same ones. They are up to date after `store`
    ///               only; until then they contain all their material.
    /// \param chords one element per row, or one for all rows.
    DexelCut cut(std::span<Dexel> dexels, std::span<const EightWholeChords> chords);

    /// Writes all gaps into the rays. They may then be changed until the next cut.
    void store(std::span<Dexel> dexels);

    /// Writes the gap of one ray into it.
    void store(std::span<Dexel> dexels, std::size_t ray);

private:
    struct Place {
        std::size_t row;
        std::size_t column;
    };

    Place place_of(std::size_t ray) const { return {ray / columns_, ray % columns_}; }
    DexelCut cut_one(std::span<Dexel> dexels, std::size_t ray, const DexelChord& chord);

    std::size_t columns_;
    std::int32_t units_;
    std::vector<RowGaps> rows_;
    std::bitset<64> is_known_;  // whether a ray has a gap
    DexelInterval common_{0, 0};
};

}  // namespace endmill
