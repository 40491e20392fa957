// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/turn_cover.h"

#include <algorithm>
#include <bit>

#include "endmill/core/detail/widest_registers.h"
#include "endmill/core/parallel.h"
#include "endmill/setup/detail/bit_transpose.h"

namespace endmill {
namespace {

constexpr std::size_t turns = turns_about_tool_axis;

// Words of a column, for 2048 cones. A column has 256 bytes, so that the columns of a
// thousand cells take 300 kB, and the rows of all runs 130 kB: together they fit a
// second-level cache.
constexpr std::size_t most_words = 32;

// Number of run lengths that are powers of two: 1, 2, 4, ..., 64.
constexpr std::size_t powers = std::bit_width(turns);

void add(std::uint64_t* target, const std::uint64_t* source, std::size_t words)
{
    for (std::size_t w = 0; w < words; ++w)
        target[w] |= source[w];
}

// Row t of power p has a bit for each cone that is reached from all turns t ... t + 2^p -
// 1. One more row has the cones that are reached from every turn.
class Rows {
public:
    Rows(std::uint64_t* first, std::size_t words) : first_{first}, words_{words} {}

    std::uint64_t* row(std::size_t power, std::size_t turn) const
    {
        return first_ + (power * turns + turn % turns) * words_;
    }
    std::uint64_t* from_all() const { return row(powers, 0); }

private:
    std::uint64_t* first_;
    std::size_t words_;
};

ENDMILL_WIDEST_REGISTERS
void reach_from_turns(const std::uint64_t* columns, std::span<const FeasibleTurns> runs,
                      std::size_t words, std::uint64_t* reached)
{
    const Rows rows{reached, words};
    for (const FeasibleTurns& run : runs) {
        const std::uint64_t* const column = columns + run.cell * words;
        const std::size_t count = run.count;
        if (count == turns) {
            add(rows.from_all(), column, words);
            continue;
        }
        const auto power = static_cast<std::size_t>(std::bit_width(count)) - 1;
        add(rows.row(power, run.first), column, words);
        const std::size_t rest = count - (std::size_t{1} << power);
        if (rest > 0)
            add(rows.row(power, run.first + rest), column, words);
    }
    for (std::size_t power = powers - 1; power > 0; --power) {
        const std::size_t half = std::size_t{1} << (power - 1);
        for (std::size_t turn = 0; turn < turns; ++turn) {
            add(rows.row(power - 1, turn), rows.row(power, turn), words);
            add(rows.row(power - 1, turn + half), rows.row(power, turn), words);
        }
    }
    for (std::size_t turn = 0; turn < turns; ++turn)
        add(rows.row(0, turn), rows.from_all(), words);
}

// The sum of the facet counts of the cones whose bit is set. The counts are stored by
// binary digits, so that the sum is made of popcounts.
ENDMILL_WIDEST_REGISTERS
std::size_t total_size(const std::uint64_t* reached, std::span<const std::uint64_t> sizes,
                       std::size_t words)
{
    std::size_t total = 0;
    for (std::size_t bit = 0; bit * words < sizes.size(); ++bit) {
        std::size_t cones = 0;
        for (std::size_t w = 0; w < words; ++w)
            cones += static_cast<std::size_t>(
                std::popcount(reached[w] & sizes[bit * words + w]));
        total += cones << bit;
    }
    return total;
}

}  // namespace

ConeTiles::ConeTiles(const DistinctCones& all, std::span<const std::size_t> cones)
    : words_{std::min((cones.size() + 63) / 64, most_words)}
{
    const std::size_t size = 64 * std::max<std::size_t>(words_, 1);
    tiles_.resize((cones.size() + size - 1) / size);
    parallel_for(tiles_.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            fill(tiles_[i], all,
                 cones.subspan(i * size, std::min(size, cones.size() - i * size)));
    });
}

void ConeTiles::fill(Tile& tile, const DistinctCones& all,
                     std::span<const std::size_t> cones) const
{
    tile.columns.assign(all.cells() * words_, 0);
    std::size_t largest = 0;
    for (const std::size_t cone : cones)
        largest = std::max(largest, all.facets(cone));
    tile.sizes.assign(static_cast<std::size_t>(std::bit_width(largest)) * words_, 0);
    for (std::size_t k = 0; k < cones.size(); ++k)
        for (std::size_t left = all.facets(cones[k]); left != 0; left &= left - 1)
            tile.sizes[static_cast<std::size_t>(std::countr_zero(left)) * words_ +
                       k / 64] |= std::uint64_t{1} << (k % 64);
    BitBlock block;
    for (std::size_t word = 0; 64 * word < cones.size(); ++word) {
        const auto part =
            cones.subspan(64 * word, std::min<std::size_t>(64, cones.size() - 64 * word));
        for (std::size_t across = 0; across < all.row_words(); ++across) {
            block.fill(0);
            for (std::size_t k = 0; k < part.size(); ++k)
                block[k] = all.row(part[k])[across];
            transpose(block);
            const std::size_t cells =
                std::min<std::size_t>(64, all.cells() - 64 * across);
            for (std::size_t i = 0; i < cells; ++i)
                tile.columns[(64 * across + i) * words_ + word] = block[i];
        }
    }
}

void ConeTiles::add_reached(std::size_t tile, std::span<const FeasibleTurns> runs,
                            std::span<std::size_t> counts,
                            TurnCoverScratch& scratch) const
{
    scratch.reached.assign((powers * turns + 1) * words_, 0);
    reach_from_turns(tiles_[tile].columns.data(), runs, words_, scratch.reached.data());
    for (std::size_t turn = 0; turn < turns; ++turn)
        counts[turn] += total_size(scratch.reached.data() + turn * words_,
                                   tiles_[tile].sizes, words_);
}

}  // namespace endmill
