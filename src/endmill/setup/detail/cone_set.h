// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/visibility/visibility.h"

namespace endmill {

/// The cones that decide whether a set of tool directions meets all visibility cones of a
/// part. Empty cones are left out, and so are cones that contain another cone.
///
/// The cones are stored as columns of *missing* bits: bit k of a cell's column is 0 if
/// the cell lies in cone k. Some cells meet all cones if the AND of their columns is 0.
class ConeSet {
public:
    /// Of equal cones the first is kept. For the time see `least_cones`.
    explicit ConeSet(const VisibilityMap& map);

    /// Takes some of the cones.
    /// \param cones of a part. \param chosen numbers of cones of which none contains
    ///         another, smallest first.
    /// \param cells ascending, with every cell of the cones that are chosen or added. All
    ///         of them are in cells(), also those in none of the cones.
    ConeSet(const DistinctCones& cones, std::span<const std::size_t> chosen,
            std::span<const std::size_t> cells);

    /// Adds a cone. smallest_cone() and other_cone() stay as they are.
    /// \param cones of the part. \param chosen number of a cone that contains none of the
    ///         others and lies in none of them.
    void add(const DistinctCones& cones, std::size_t chosen);

    /// Facets whose cones are kept, ascending.
    std::span<const std::size_t> facets() const { return facets_; }

    /// Cells that lie in at least one kept cone, or those given; ascending.
    std::span<const std::size_t> cells() const { return cells_; }

    /// Words of a column: 1, 2 or a multiple of 4. Bits beyond the last cone are 0.
    std::size_t words() const { return words_; }

    /// The column of cells()[index]. \pre index < cells().size().
    const std::uint64_t* missing(std::size_t index) const
    {
        return missing_.data() + index * words_;
    }

    /// The column of an empty set of cells, which misses every cone: a 1 for each cone.
    const std::uint64_t* everything() const { return everything_.data(); }

    /// The cone of fewest cells, as indices into cells(). Every set that meets all cones
    /// contains one of these cells. Empty if there is no cone.
    std::span<const std::size_t> smallest_cone() const { return smallest_; }

    /// The smallest cone that shares no cell with smallest_cone(), as indices into
    /// cells(). Every set that meets all cones contains a cell of each of the two. All
    /// cells if no such cone exists.
    std::span<const std::size_t> other_cone() const { return other_; }

private:
    void fill(const DistinctCones& cones, std::span<const std::size_t> chosen);
    void fill_columns(const DistinctCones& cones, std::span<const std::size_t> chosen);
    void widen(std::size_t words);

    std::vector<std::size_t> facets_;
    std::vector<std::size_t> cells_;
    std::size_t words_ = 0;
    std::vector<std::uint64_t> missing_;
    std::vector<std::uint64_t> everything_;
    std::vector<std::size_t> smallest_;
    std::vector<std::size_t> other_;
};

/// Calls `body` with the number of words of a column as a compile-time constant, so that
/// loops over words unroll. The constant is 0 if the number is not 1, 2 or 4.
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
        case 8:
            return body(std::integral_constant<std::size_t, 8>{});
        case 12:
            return body(std::integral_constant<std::size_t, 12>{});
        case 16:
            return body(std::integral_constant<std::size_t, 16>{});
        default:
            return body(std::integral_constant<std::size_t, 0>{});
    }
}

/// Operations on columns of missing bits of `W` words, or of `words` words if `W` is 0.
template <std::size_t W>
struct MissingWords {
    std::size_t words;  ///< length of a column, used if W is 0

    std::size_t count() const { return W != 0 ? W : words; }  ///< length of a column

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

    /// Returns true if the cells of both columns together miss no cone.
    bool complete(const std::uint64_t* a, const std::uint64_t* b) const
    {
        std::uint64_t left = 0;
        for (std::size_t k = 0; k < count(); ++k)
            left |= a[k] & b[k];
        return left == 0;
    }
};

}  // namespace endmill
