// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "endmill/visibility/visibility.h"

namespace endmill {

/// The visibility cones that decide whether a set of tool directions meets all cones: empty
/// ones are left out, and so are those that hold another one whole, since what meets the
/// other meets them. Kept as columns of *missing* bits: bit k of a cell's column is 0 where
/// the cell lies in cone k, so that cells together meet all cones where the AND of their
/// columns is 0.
class ConeSet {
public:
    /// Of equal cones the first stays. See `least_cones` for the time it takes.
    explicit ConeSet(const VisibilityMap& map);

    /// Facets whose cones are kept, ascending.
    std::span<const std::size_t> facets() const { return facets_; }

    /// Cells that lie in some cone, ascending.
    std::span<const std::size_t> cells() const { return cells_; }

    /// Words of a column: 1, 2, 4 or a multiple of 4; the bits beyond the last cone are 0.
    std::size_t words() const { return words_; }

    /// What cells()[index] misses. \pre index < cells().size().
    const std::uint64_t* missing(std::size_t index) const
    {
        return missing_.data() + index * words_;
    }

    /// What no cell misses: a 1 for each cone.
    const std::uint64_t* everything() const { return everything_.data(); }

    /// Numbers of the cells, in cells(), of the cone of fewest cells: every set that meets all
    /// cones holds one of them. Empty if there is no cone.
    std::span<const std::size_t> smallest_cone() const { return smallest_; }

    /// The same of the smallest cone that shares no cell with that one, so that every set that
    /// meets all cones holds two different cells, one of each; all cells if there is none.
    std::span<const std::size_t> other_cone() const { return other_; }

private:
    std::vector<std::size_t> facets_;
    std::vector<std::size_t> cells_;
    std::size_t words_ = 1;
    std::vector<std::uint64_t> missing_;
    std::vector<std::uint64_t> everything_;
    std::vector<std::size_t> smallest_;
    std::vector<std::size_t> other_;
};

/// Calls `body` with the number of words of a column: as a constant where it is a usual one,
/// so that loops over words unroll, else 0.
template <typename Body>
auto with_words(std::size_t words, Body&& body)
{
    switch (words) {
        case 1:
            return body(std::integral_constant<std::size_t, 1>{});
        case 2:
            return body(std::integral_constant<std::size_t, 2>{});
        case 4:
            return body(std::integral_constant<std::size_t, 4>{});
        default:
            return body(std::integral_constant<std::size_t, 0>{});
    }
}

/// Columns of missing bits of `W` words, or of as many as told if `W` is 0.
template <std::size_t W>
struct MissingWords {
    std::size_t words;  ///< of a column

    std::size_t count() const { return W != 0 ? W : words; }  ///< words of a column

    /// target = source.
    void copy(std::uint64_t* target, const std::uint64_t* source) const
    {
        for (std::size_t k = 0; k < count(); ++k)
            target[k] = source[k];
    }

    /// target = target AND source.
    void meet(std::uint64_t* target, const std::uint64_t* source) const
    {
        for (std::size_t k = 0; k < count(); ++k)
            target[k] &= source[k];
    }

    /// Whether nothing is missing where both are there.
    bool complete(const std::uint64_t* a, const std::uint64_t* b) const
    {
        std::uint64_t left = 0;
        for (std::size_t k = 0; k < count(); ++k)
            left |= a[k] & b[k];
        return left == 0;
    }
};

}  // namespace endmill
