// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/accessibility/cone_set.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <optional>

namespace endmill {
namespace {

/// Cones as rows: a bit for each cell.
struct ConeRows {
    std::size_t words = 0;  ///< of a row
    std::vector<std::uint64_t> bits;
    std::vector<std::size_t> sizes;  ///< cells of each cone

    std::span<const std::uint64_t> row(std::size_t facet) const
    {
        return {bits.data() + facet * words, words};
    }
};

ConeRows cone_rows(const VisibilityMap& map)
{
    ConeRows rows;
    rows.words = (map.cells() + 63) / 64;
    rows.bits.resize(rows.words * map.facets());
    rows.sizes.resize(map.facets());
    for (std::size_t cell = 0; cell < map.cells(); ++cell) {
        const auto column = map.column(cell);
        for (std::size_t word = 0; word < column.size(); ++word) {
            for (std::uint64_t rest = column[word]; rest != 0; rest &= rest - 1) {
                const std::size_t facet = 64 * word + std::size_t(std::countr_zero(rest));
                rows.bits[facet * rows.words + cell / 64] |= std::uint64_t{1}
                                                             << cell % 64;
                ++rows.sizes[facet];
            }
        }
    }
    return rows;
}

bool holds(std::span<const std::uint64_t> outer, std::span<const std::uint64_t> inner)
{
    for (std::size_t k = 0; k < inner.size(); ++k)
        if ((inner[k] & ~outer[k]) != 0)
            return false;
    return true;
}

/// Smallest first: a cone can only hold one that comes before it.
std::vector<std::size_t> least_cones(const ConeRows& rows)
{
    std::vector<std::size_t> order(rows.sizes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return rows.sizes[a] < rows.sizes[b];
    });
    std::vector<std::size_t> kept;
    for (const std::size_t facet : order) {
        if (rows.sizes[facet] == 0)
            continue;
        const auto row = rows.row(facet);
        const bool has_smaller =
            std::any_of(kept.begin(), kept.end(),
                        [&](std::size_t other) { return holds(row, rows.row(other)); });
        if (!has_smaller)
            kept.push_back(facet);
    }
    return kept;
}

std::size_t padded_words(std::size_t cones)
{
    const std::size_t words = std::max<std::size_t>((cones + 63) / 64, 1);
    return words <= 2 ? words : (words + 3) / 4 * 4;
}

/// Of the cones `order`, the first that shares no cell with its first.
std::optional<std::size_t> apart_from_first(const ConeRows& rows,
                                            std::span<const std::size_t> order)
{
    for (const std::size_t facet : order) {
        const auto first = rows.row(order.front());
        const auto row = rows.row(facet);
        std::uint64_t shared = 0;
        for (std::size_t k = 0; k < row.size(); ++k)
            shared |= first[k] & row[k];
        if (shared == 0)
            return facet;
    }
    return std::nullopt;
}

}  // namespace

ConeSet::ConeSet(const VisibilityMap& map)
{
    const ConeRows rows = cone_rows(map);
    facets_ = least_cones(rows);
    if (facets_.empty()) {
        everything_.resize(words_);
        return;
    }
    const std::size_t smallest = facets_.front();
    const auto other = apart_from_first(rows, facets_);
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
        if (!other || map.is_accessible(*other, cell))
            other_.push_back(cells_.size());
        cells_.push_back(cell);
        missing_.insert(missing_.end(), column.begin(), column.end());
    }
}

}  // namespace endmill
