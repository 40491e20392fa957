// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/setup/detail/distinct_cones.h"
#include "endmill/setup/several_setups.h"

namespace endmill {

/// Memory for `ConeTiles::add_reached`, one a thread.
struct TurnCoverScratch {
    std::vector<std::uint64_t> reached;  ///< a row for each power of two and turn
};

/// Cones in tiles of some thousand, small enough that the columns of all cells stay in a core's
/// cache while tool axis after tool axis is tried.
class ConeTiles {
public:
    /// \param cones their numbers; fastest with those of most facets first.
    ConeTiles(const DistinctCones& all, std::span<const std::size_t> cones);

    std::size_t size() const { return tiles_.size(); }  ///< number of tiles

    /// Adds to `counts`, for each turn about a tool axis, the facets whose cone lies in `tile`
    /// and holds a cell that is feasible from there. Runs of turns are halved: a run of n is
    /// two of the largest power of two in it, and those of each power are added to those of the
    /// next lower one, so that a cell costs two columns and not n.
    /// \param runs as `feasible_turns` gives them. \param counts one for each turn.
    /// \pre tile < size().
    void add_reached(std::size_t tile, std::span<const FeasibleTurns> runs,
                     std::span<std::size_t> counts, TurnCoverScratch& scratch) const;

private:
    struct Tile {
        std::vector<std::uint64_t> columns;  // of cells, each `words_`
        std::vector<std::uint64_t> sizes;    // bit b of the cones' facets, each `words_`
    };

    void fill(Tile& tile, const DistinctCones& all,
              std::span<const std::size_t> cones) const;

    std::size_t words_;  // of a column of a tile
    std::vector<Tile> tiles_;
};

}  // namespace endmill
