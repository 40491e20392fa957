// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "endmill/visibility/visibility.h"

namespace endmill {

/// The different visibility cones of a part that are not empty, in the order of their first
/// facets, each as a row of bits.
class DistinctCones {
public:
    /// Stands for the cone of a facet that no cell reaches.
    static constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

    /// O(facets * cells / 64), and while it works as much memory as the map.
    explicit DistinctCones(const VisibilityMap& map);

    std::size_t size() const { return facets_.size(); }  ///< number of cones
    std::size_t cells() const { return cells_; }         ///< that the map has

    /// The number of each facet's cone, or `none`.
    std::span<const std::size_t> cone_of() const { return cone_of_; }

    /// How many facets have it. \pre cone < size().
    std::size_t facets(std::size_t cone) const { return facets_[cone]; }

    /// The cells of a cone: bit i % 64 of word i / 64 tells of cell i. \pre cone < size().
    std::span<const std::uint64_t> row(std::size_t cone) const
    {
        return {rows_.data() + cone * row_words_, row_words_};
    }

    std::size_t row_words() const { return row_words_; }  ///< words of a row

    /// The map of a part with one facet for each cone.
    VisibilityMap map() const;

    /// The same of some cones. \pre all of `cones` are below size().
    VisibilityMap map(std::span<const std::size_t> cones) const;

private:
    std::size_t cells_;
    std::size_t row_words_;
    std::vector<std::uint64_t> rows_;
    std::vector<std::size_t> cone_of_;
    std::vector<std::size_t> facets_;
};

}  // namespace endmill
