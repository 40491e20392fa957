// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "endmill/stock/detail/swept_move.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// The moves over each group of 4 by 4 tiles, in the order of the moves. It takes four
/// bytes per pair of a move and a group, and eight bytes per group.
class MoveBins {
public:
    static constexpr int group_side = 4;  ///< tiles along a side of a group

    /// Takes moves from the start of `moves` until there are `most_entries` pairs of a
    /// move and a group. It takes at least one move.
    /// \param reach distance from its line up to which a move affects the stock, mm.
    MoveBins(const StockGrid& grid, std::span<const SweptMove> moves, double reach,
             std::size_t most_entries);

    std::size_t moves() const { return moves_; }    ///< number of moves taken
    int group_columns() const { return columns_; }  ///< number of groups along x
    int group_rows() const { return rows_; }        ///< number of groups along y

    /// Numbers of the moves over a group, rising. Groups are numbered row by row.
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
