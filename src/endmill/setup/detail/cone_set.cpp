// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/cone_set.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "endmill/setup/detail/bit_transpose.h"
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

bool holds(std::span<const std::uint64_t> row, std::size_t cell)
{
    return (row[cell / 64] >> cell % 64 & 1) != 0;
}

/// The cells of these cones, ascending.
std::vector<std::size_t> cells_of(const DistinctCones& cones,
                                  std::span<const std::size_t> chosen)
{
    std::vector<std::uint64_t> any(cones.row_words());
    for (const std::size_t cone : chosen)
        for (std::size_t k = 0; k < any.size(); ++k)
            any[k] |= cones.row(cone)[k];
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < cones.cells(); ++cell)
        if ((any[cell / 64] >> cell % 64 & 1) != 0)
            cells.push_back(cell);
    return cells;
}

}  // namespace

ConeSet::ConeSet(const VisibilityMap& map)
{
    const DistinctCones all{map};
    const std::vector<std::size_t> least = least_cones(all);
    cells_ = cells_of(all, least);
    fill(all, least);
}

ConeSet::ConeSet(const DistinctCones& cones, std::span<const std::size_t> chosen,
                 std::span<const std::size_t> cells)
    : cells_{cells.begin(), cells.end()}
{
    fill(cones, chosen);
}

void ConeSet::fill(const DistinctCones& cones, std::span<const std::size_t> chosen)
{
    std::vector<std::size_t> in_order{chosen.begin(), chosen.end()};
    std::sort(in_order.begin(), in_order.end());
    for (const std::size_t cone : in_order)
        facets_.push_back(cones.first_facet(cone));
    fill_columns(cones, in_order);
    if (chosen.empty())
        return;
    const auto smallest = cones.row(chosen.front());
    const auto apart = apart_from_first(cones, chosen);
    for (std::size_t at = 0; at < cells_.size(); ++at) {
        if (holds(smallest, cells_[at]))
            smallest_.push_back(at);
        if (!apart || holds(cones.row(*apart), cells_[at]))
            other_.push_back(at);
    }
}

/// Fills the columns of these cones, in blocks of 64 x 64 bits.
void ConeSet::fill_columns(const DistinctCones& cones,
                           std::span<const std::size_t> chosen)
{
    widen(padded_words(chosen.size()));
    BitBlock block;
    for (std::size_t word = 0; 64 * word < chosen.size(); ++word) {
        const auto here = chosen.subspan(
            64 * word, std::min<std::size_t>(64, chosen.size() - 64 * word));
        everything_[word] = ~std::uint64_t{0} >> (64 - here.size());
        std::size_t at = 0;
        for (std::size_t across = 0; across < cones.row_words(); ++across) {
            block.fill(0);
            for (std::size_t k = 0; k < here.size(); ++k)
                block[k] = cones.row(here[k])[across];
            transpose(block);
            for (; at < cells_.size() && cells_[at] / 64 == across; ++at)
                missing_[at * words_ + word] =
                    everything_[word] & ~block[cells_[at] % 64];
        }
    }
}

/// Lengthens the columns.
void ConeSet::widen(std::size_t words)
{
    std::vector<std::uint64_t> wide(cells_.size() * words);
    for (std::size_t at = 0; at < wide.size() / words && !missing_.empty(); ++at)
        std::copy_n(missing(at), words_, wide.data() + at * words);
    missing_ = std::move(wide);
    everything_.resize(words);
    words_ = words;
}

void ConeSet::add(const DistinctCones& cones, std::size_t chosen)
{
    const std::size_t number = facets_.size();
    if (number == 64 * words_)
        widen(padded_words(number + 1));
    const std::size_t facet = cones.first_facet(chosen);
    facets_.insert(std::upper_bound(facets_.begin(), facets_.end(), facet), facet);
    const std::uint64_t bit = std::uint64_t{1} << number % 64;
    everything_[number / 64] |= bit;
    const auto row = cones.row(chosen);
    for (std::size_t at = 0; at < cells_.size(); ++at)
        if (!holds(row, cells_[at]))
            missing_[at * words_ + number / 64] |= bit;
}

}  // namespace endmill
