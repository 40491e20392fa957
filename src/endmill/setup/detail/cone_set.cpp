// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/cone_set.h"

#include <algorithm>
#include <optional>

#include "endmill/setup/detail/least_cones.h"

namespace endmill {
namespace {

/// Words of a column, rounded up to a multiple of 4 from 3 words on, so that loops
/// vectorise.
std::size_t padded_words(std::size_t cones)
{
    const std::size_t words = std::max<std::size_t>((cones + 63) / 64, 1);
    return words <= 2 ? words : (words + 3) / 4 * 4;
}

/// The first cone in `order` that shares no cell with order.front().
std::optional<std::size_t> apart_from_first(const DistinctCones& cones,
                                            std::span<const std::size_t> order)
{
    for (const std::size_t cone : order) {
        const auto first = cones.row(order.front());
        const auto row = cones.row(cone);
        std::uint64_t shared = 0;
        for (std::size_t k = 0; k < row.size(); ++k)
            shared |= first[k] & row[k];
        if (shared == 0)
            return cone;
    }
    return std::nullopt;
}

/// For each cone the lowest facet that has it.
std::vector<std::size_t> first_facets(const DistinctCones& cones)
{
    std::vector<std::size_t> facets(cones.size(), cones.none);
    for (std::size_t facet = 0; facet < cones.cone_of().size(); ++facet) {
        const std::size_t cone = cones.cone_of()[facet];
        if (cone != cones.none && facets[cone] == cones.none)
            facets[cone] = facet;
    }
    return facets;
}

}  // namespace

ConeSet::ConeSet(const VisibilityMap& map)
{
    const DistinctCones all{map};
    const std::vector<std::size_t> least = least_cones(all);
    const std::vector<std::size_t> facet_of = first_facets(all);
    for (const std::size_t cone : least)
        facets_.push_back(facet_of[cone]);
    if (facets_.empty()) {
        everything_.resize(words_);
        return;
    }
    const std::size_t smallest = facets_.front();
    const auto other = apart_from_first(all, least);
    std::sort(facets_.begin(), facets_.end());
    words_ = padded_words(facets_.size());
    everything_.resize(words_);
    for (std::size_t k = 0; k < facets_.size(); ++k)
        everything_[k / 64] |= std::uint64_t{1} << k % 64;

    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        std::vector<std::uint64_t> column = everything_;
        for (std::size_t k = 0; k < facets_.size(); ++k)
            if (map.is_accessible(facets_[k], cell))
                column[k / 64] &= ~(std::uint64_t{1} << k % 64);
        if (column == everything_)
            continue;
        if (map.is_accessible(smallest, cell))
            smallest_.push_back(cells_.size());
        if (!other || map.is_accessible(facet_of[*other], cell))
            other_.push_back(cells_.size());
        cells_.push_back(cell);
        missing_.insert(missing_.end(), column.begin(), column.end());
    }
}

}  // namespace endmill
