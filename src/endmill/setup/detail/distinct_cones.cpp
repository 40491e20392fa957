// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/distinct_cones.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "endmill/core/parallel.h"
#include "endmill/setup/detail/bit_transpose.h"

namespace endmill {
namespace {

using Row = std::span<const std::uint64_t>;

// The map transposed: a row of bits for each facet, in blocks of 64 x 64 bits.
std::vector<std::uint64_t> rows_of(const VisibilityMap& map, std::size_t row_words)
{
    std::vector<std::uint64_t> rows(64 * map.words() * row_words);
    parallel_for(map.words(), [&](std::size_t begin, std::size_t end) {
        BitBlock block;
        for (std::size_t across = 0; across < row_words; ++across) {
            const std::size_t cells =
                std::min<std::size_t>(64, map.cells() - 64 * across);
            for (std::size_t word = begin; word < end; ++word) {
                block.fill(0);
                for (std::size_t i = 0; i < cells; ++i)
                    block[i] = map.column(64 * across + i)[word];
                transpose(block);
                for (std::size_t k = 0; k < 64; ++k)
                    rows[(64 * word + k) * row_words + across] = block[k];
            }
        }
    });
    return rows;
}

// A multiplicative hash: the factor is an odd number close to 2^64 / golden ratio. The
// shift brings the high bits, which depend on all bits of the word, down to those that
// select a slot.
std::uint64_t hash_of(Row row)
{
    std::uint64_t hash = 0;
    for (const std::uint64_t word : row) {
        hash = (hash ^ word) * 0x9e3779b97f4a7c15;
        hash ^= hash >> 32;
    }
    return hash;
}

// A hash table with open addressing from the content of a row to the number of its cone.
// The rows themselves are stored elsewhere.
class RowTable {
public:
    explicit RowTable(std::size_t most)
        : slots_(std::bit_ceil(2 * most + 1), DistinctCones::none)
    {
    }

    // The slot that holds the number of an equal row, or else a free slot for this row.
    template <class RowOf>
    std::size_t& slot(Row row, const RowOf& row_of)
    {
        std::size_t at = hash_of(row) & (slots_.size() - 1);
        while (slots_[at] != DistinctCones::none &&
               !std::ranges::equal(row_of(slots_[at]), row))
            at = (at + 1) & (slots_.size() - 1);
        return slots_[at];
    }

private:
    std::vector<std::size_t> slots_;
};

}  // namespace

DistinctCones::DistinctCones(const VisibilityMap& map)
    : cells_{map.cells()},
      row_words_{(map.cells() + 63) / 64},
      rows_{rows_of(map, row_words_)},
      cone_of_(map.facets(), none)
{
    RowTable table{map.facets()};
    for (std::size_t facet = 0; facet < map.facets(); ++facet) {
        const Row found = row(facet);
        if (std::ranges::all_of(found, [](std::uint64_t word) { return word == 0; }))
            continue;
        std::size_t& cone = table.slot(found, [this](std::size_t i) { return row(i); });
        // The row of a new cone is copied to the front, over a row that is no longer
        // needed.
        if (cone == none) {
            cone = facets_.size();
            facets_.push_back(0);
            first_facets_.push_back(facet);
            std::ranges::copy(
                found, rows_.begin() + static_cast<std::ptrdiff_t>(cone * row_words_));
        }
        cone_of_[facet] = cone;
        ++facets_[cone];
    }
    rows_.resize(facets_.size() * row_words_);
    rows_.shrink_to_fit();
}

std::vector<std::size_t> DistinctCones::similar_together() const
{
    // Cells of neighbouring numbers lie side by side. Multiples of the golden ratio spread the
    // numbers, the first of them most: sorting divides the cones by one cell after the other.
    std::vector<std::uint64_t> answers(size());
    for (int k = 0; k < 64; ++k) {
        const double turns = k * std::numbers::phi;
        const auto cell = static_cast<std::size_t>((turns - std::floor(turns)) *
                                                   static_cast<double>(cells_));
        for (std::size_t cone = 0; cone < size(); ++cone)
            answers[cone] = answers[cone] << 1 | (row(cone)[cell / 64] >> cell % 64 & 1);
    }
    std::vector<std::size_t> cones(size());
    std::iota(cones.begin(), cones.end(), std::size_t{0});
    std::ranges::stable_sort(cones, {}, [&](std::size_t cone) { return answers[cone]; });
    return cones;
}

VisibilityMap DistinctCones::map() const
{
    std::vector<std::size_t> all(size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return map(all);
}

VisibilityMap DistinctCones::map(std::span<const std::size_t> cones) const
{
    VisibilityMap result{cones.size(), cells_};
    parallel_for(result.words(), [&](std::size_t begin, std::size_t end) {
        BitBlock block;
        for (std::size_t across = 0; across < row_words_; ++across) {
            const std::size_t cells = std::min<std::size_t>(64, cells_ - 64 * across);
            for (std::size_t word = begin; word < end; ++word) {
                block.fill(0);
                const std::size_t count =
                    std::min<std::size_t>(64, cones.size() - 64 * word);
                for (std::size_t k = 0; k < count; ++k)
                    block[k] = row(cones[64 * word + k])[across];
                transpose(block);
                for (std::size_t i = 0; i < cells; ++i)
                    result.column(64 * across + i)[word] = block[i];
            }
        }
    });
    return result;
}

VisibilityMap map_of_distinct_cones(const VisibilityMap& map)
{
    const DistinctCones cones{map};
    return cones.map(cones.similar_together());
}

}  // namespace endmill
