// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/visibility/visibility.h"

namespace endmill {

/// The different visibility cones of a part, without the empty one, in the order of their
/// first facets. Each cone is a row of bits over the cells. Large parts have many facets
/// with equal cones, and the searches look at each cone once.
class DistinctCones {
public:
    /// Number in `cone_of` of a facet that no cell reaches.
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    /// Takes O(facets * cells / 64) operations, and as much memory as the map while it
    /// works.
    explicit DistinctCones(const VisibilityMap& map);

    std::size_t size() const { return facets_.size(); }  ///< number of cones
    std::size_t cells() const { return cells_; }         ///< number of cells of the map

    /// For each facet the number of its cone, or `none`.
    std::span<const std::size_t> cone_of() const { return cone_of_; }

    /// Number of facets that have this cone. \pre cone < size().
    std::size_t facets(std::size_t cone) const { return facets_[cone]; }

    /// The lowest facet that has this cone. \pre cone < size().
    std::size_t first_facet(std::size_t cone) const { return first_facets_[cone]; }

    /// The cells of a cone: bit i % 64 of word i / 64 is set if cell i belongs to it.
    /// \pre cone < size().
    std::span<const std::uint64_t> row(std::size_t cone) const
    {
        return {rows_.data() + cone * row_words_, row_words_};
    }

    std::size_t row_words() const { return row_words_; }  ///< words of a row

    /// All cones, with similar ones side by side: those that agree in 64 cells all over the
    /// sphere. In maps of this order `for_each_nearest_cells` is fast for every part.
    std::vector<std::size_t> similar_together() const;

    /// A visibility map with one facet for each cone.
    VisibilityMap map() const;

    /// A visibility map with one facet for each of `cones`. \pre all of them are below
    /// size().
    VisibilityMap map(std::span<const std::size_t> cones) const;

private:
    std::size_t cells_;
    std::size_t row_words_;
    std::vector<std::uint64_t> rows_;
    std::vector<std::size_t> cone_of_;
    std::vector<std::size_t> facets_;        // by cone: number of its facets
    std::vector<std::size_t> first_facets_;  // by cone
};

/// The different cones of a map as a map with one facet for each, similar ones side by side.
/// The memory of DistinctCones is free again when it returns.
VisibilityMap map_of_distinct_cones(const VisibilityMap& map);

}  // namespace endmill
