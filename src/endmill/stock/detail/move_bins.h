// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Moves sorted by the groups of 4 by 4 tiles that they pass over, in the order of the
/// moves. Four bytes a move and group, and eight a group.
class MoveBins {
public:
    static constexpr int group_side = 4;  ///< tiles

    /// Takes moves from the start of `moves` until `most_entries` of a move and a group
    /// are reached; always one, even if it alone has more.
    /// \param reach in mm, how far from its line a move is felt.
    MoveBins(const StockGrid& grid, std::span<const SweptMove> moves, double reach,
             std::size_t most_entries);

    std::size_t moves() const { return moves_; }  ///< taken
    int group_columns() const { return columns_; }
    int group_rows() const { return rows_; }

    /// The moves over a group, by their numbers in the span, rising.
    std::span<const std::uint32_t> over(std::size_t group) const
    {
        return {entries_.data() + begins_[group], begins_[group + 1] - begins_[group]};
    }

private:
    template <typename Visit>
    void for_each_group(const StockGrid& grid, const SweptMove& move, double reach,
                        const Visit& visit) const;

    int columns_;
    int rows_;
    std::size_t moves_ = 0;
    std::vector<std::size_t> begins_;  // of each group in entries_, and the end
    std::vector<std::uint32_t> entries_;
};

}  // namespace endmill
