// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/detail/feasible_turns.h"

namespace endmill {

/// Working memory of `ConeTiles::add_reached`, one for each thread.
struct TurnCoverScratch {
    std::vector<std::uint64_t> reached;  ///< a row for each power of two and each turn
};

/// Cones in tiles of up to 2048. A tile is small enough that the columns of all cells
/// stay in a core's cache while one tool axis after the other is tried.
class ConeTiles {
public:
    /// \param all cones of a part.
    /// \param cones numbers of the cones to take; fastest if those of most facets come
    ///         first.
    ConeTiles(const DistinctCones& all, std::span<const std::size_t> cones);

    std::size_t size() const { return tiles_.size(); }  ///< number of tiles

    /// Counts, for each turn about a tool axis, the facets whose cone lies in `tile` and
    /// contains a cell that the machine reaches from this turn.
    ///
    /// A run of n turns is the union of two runs whose length is the largest power of two
    /// up to n. Runs of each length are collected first, then split into two runs of half
    /// the length. So a run costs two columns instead of n.
    /// \param tile below size(). \param runs from `feasible_turns`.
    /// \param counts one for each turn; the facets are added to them.
    /// \param scratch of the calling thread.
    void add_reached(std::size_t tile, std::span<const FeasibleTurns> runs,
                     std::span<std::size_t> counts, TurnCoverScratch& scratch) const;

private:
    struct Tile {
        std::vector<std::uint64_t> columns;  // for each cell `words_` words, a bit a cone
        std::vector<std::uint64_t>
            sizes;  // for each binary digit of the facet counts the
                    // same
    };

    void fill(Tile& tile, const DistinctCones& all,
              std::span<const std::size_t> cones) const;

    std::size_t words_;  // length of a column of a tile
    std::vector<Tile> tiles_;
};

}  // namespace endmill
