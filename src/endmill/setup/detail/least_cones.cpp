// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/least_cones.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <random>
#include <span>

#include "endmill/core/parallel.h"

// How minimal cones are found.
//
// 1. Cones are taken in the order of their sizes, so that a cone can contain only cones
//    that were taken before it. Cones of equal size do not contain each other and are
//    tested in parallel.
// 2. To test whether a cone contains a kept cone, 64 cells outside it are chosen. A kept
//    cone with one of these cells is not contained. Kept cones are stored in tiles of 512
//    with a line of 512 bits for each cell, so that a cell excludes the cones of a tile
//    by one OR of a line.
// 3. The few kept cones that remain are compared cell by cell.
// 4. A cone that contains no kept cone is kept.

namespace endmill {
namespace {

using Row = std::span<const std::uint64_t>;

constexpr std::size_t tile_words = 8;  // a line of a tile fills a cache line of 64 bytes
constexpr std::size_t tile_cones = 64 * tile_words;

// Number of cells outside a cone that are used as a filter. A kept cone of a tenth of all
// cells that is not contained passes the filter with a probability of 0.001.
constexpr std::size_t filter_cells = 64;

using Line = std::array<std::uint64_t, tile_words>;

bool holds(Row outer, Row inner)
{
    for (std::size_t k = 0; k < inner.size(); ++k)
        if ((inner[k] & ~outer[k]) != 0)
            return false;
    return true;
}

// The cones kept so far, in tiles. A tile has a line of bits for each cell.
class KeptCones {
public:
    explicit KeptCones(const DistinctCones& cones) : cones_{cones} {}

    std::span<const std::size_t> numbers() const { return kept_; }
    std::size_t tiles() const
    {
        return lines_.size() / std::max<std::size_t>(width(), 1);
    }

    void keep(std::size_t cone)
    {
        const std::size_t place = kept_.size() % tile_cones;
        if (place == 0)
            lines_.resize(lines_.size() + width());
        Line* const tile = lines_.data() + lines_.size() - width();
        const Row row = cones_.row(cone);
        for (std::size_t word = 0; word < row.size(); ++word)
            for (std::uint64_t rest = row[word]; rest != 0; rest &= rest - 1)
                tile[64 * word + static_cast<std::size_t>(std::countr_zero(rest))]
                    [place / 64] |= std::uint64_t{1} << (place % 64);
        kept_.push_back(cone);
    }

    // Tests whether `row` contains a cone of the tile. `outside` are some cells not in
    // `row`.
    bool has_inside(std::size_t tile, Row row, std::span<const std::size_t> outside) const
    {
        Line excluded{};
        for (const std::size_t cell : outside) {
            const Line& line = lines_[tile * width() + cell];
            for (std::size_t w = 0; w < tile_words; ++w)
                excluded[w] |= line[w];
        }
        for (std::size_t k = 0; k < tile_words; ++k)
            for (std::uint64_t rest = ~excluded[k]; rest != 0; rest &= rest - 1) {
                const std::size_t at = tile * tile_cones + 64 * k +
                                       static_cast<std::size_t>(std::countr_zero(rest));
                if (at < kept_.size() && holds(row, cones_.row(kept_[at])))
                    return true;
            }
        return false;
    }

private:
    std::size_t width() const { return 64 * cones_.row_words(); }

    const DistinctCones& cones_;
    std::vector<std::size_t> kept_;
    std::vector<Line> lines_;
};

std::vector<std::size_t> sizes_of(const DistinctCones& cones)
{
    std::vector<std::size_t> sizes(cones.size(), 0);
    for (std::size_t cone = 0; cone < sizes.size(); ++cone)
        for (const std::uint64_t word : cones.row(cone))
            sizes[cone] += static_cast<std::size_t>(std::popcount(word));
    return sizes;
}

// The cells in a fixed random order. Neighbouring cells belong to nearly the same cones,
// so that cells far apart make a better filter.
std::vector<std::size_t> shuffled_cells(std::size_t count)
{
    std::vector<std::size_t> cells(count);
    std::iota(cells.begin(), cells.end(), std::size_t{0});
    std::mt19937 random{1};
    for (std::size_t left = count; left > 1; --left)
        std::swap(cells[left - 1], cells[random() % left]);
    return cells;
}

class Sieve {
public:
    explicit Sieve(const DistinctCones& cones)
        : cones_{cones},
          kept_{cones},
          shuffled_{shuffled_cells(cones.cells())}
    {
    }

    // Keeps the minimal cones among some of equal size. \pre the size grows from call to
    // call.
    void take(std::span<const std::size_t> equals)
    {
        std::vector<char> has_smaller(equals.size(), 0);
        parallel_for(equals.size(), [&](std::size_t begin, std::size_t end) {
            sift(equals.subspan(begin, end - begin),
                 std::span{has_smaller}.subspan(begin, end - begin));
        });
        for (std::size_t i = 0; i < equals.size(); ++i)
            if (has_smaller[i] == 0)
                kept_.keep(equals[i]);
    }

    std::vector<std::size_t> kept() const
    {
        return {kept_.numbers().begin(), kept_.numbers().end()};
    }

private:
    // Tests the cones against one tile after the other, so that a tile stays in the
    // cache.
    void sift(std::span<const std::size_t> equals, std::span<char> has_smaller) const
    {
        std::vector<std::vector<std::size_t>> outside;
        for (const std::size_t cone : equals)
            outside.push_back(cells_outside(cone));
        for (std::size_t tile = 0; tile < kept_.tiles(); ++tile)
            for (std::size_t i = 0; i < equals.size(); ++i)
                if (has_smaller[i] == 0 &&
                    kept_.has_inside(tile, cones_.row(equals[i]), outside[i]))
                    has_smaller[i] = 1;
    }

    std::vector<std::size_t> cells_outside(std::size_t cone) const
    {
        std::vector<std::size_t> outside;
        for (const std::size_t cell : shuffled_)
            if ((cones_.row(cone)[cell / 64] >> (cell % 64) & 1) == 0) {
                outside.push_back(cell);
                if (outside.size() == filter_cells)
                    break;
            }
        return outside;
    }

    const DistinctCones& cones_;
    KeptCones kept_;
    std::vector<std::size_t> shuffled_;
};

}  // namespace

std::vector<std::size_t> least_cones(const DistinctCones& cones)
{
    const std::vector<std::size_t> sizes = sizes_of(cones);
    std::vector<std::size_t> order(cones.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sizes[a] < sizes[b]; });
    Sieve sieve{cones};
    for (std::size_t begin = 0; begin < order.size();) {
        std::size_t end = begin + 1;
        while (end < order.size() && sizes[order[end]] == sizes[order[begin]])
            ++end;
        sieve.take(std::span{order}.subspan(begin, end - begin));
        begin = end;
    }
    return sieve.kept();
}

}  // namespace endmill
