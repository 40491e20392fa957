// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/move_bins.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace endmill {
namespace {

constexpr int cells_in_group = MoveBins::group_side * HeightStock::tile_side;

int groups_across(int cells)
{
    return (cells - 1) / cells_in_group + 1;
}

// Returns the number of the group that contains a place, given in groups, clamped to the
// groups that exist.
int group_at(double place, int groups)
{
    return static_cast<int>(std::clamp(std::floor(place), 0.0, groups - 1.0));
}

// A part of a move, as shares of its length.
struct Span {
    double low;
    double high;
};

// Returns the part of the move whose y lies in [low, high]; the whole move if it runs
// along x.
Span part_between(const SweptMove& move, double low, double high)
{
    const double dy = move.length * move.direction_y;
    const double to_low = (low - move.y) / dy;
    const double to_high = (high - move.y) / dy;
    if (!(std::isfinite(to_low) && std::isfinite(to_high)))
        return {0, 1};
    return {std::clamp(std::min(to_low, to_high), 0.0, 1.0),
            std::clamp(std::max(to_low, to_high), 0.0, 1.0)};
}

}  // namespace

// Calls visit(group) for all groups within `reach` of the move, and for few others. In
// each row of groups, the part of the move near the row determines the columns.
template <typename Visit>
void MoveBins::for_each_group(const StockGrid& grid, const SweptMove& move, double reach,
                              const Visit& visit) const
{
    const double width = cells_in_group * grid.pitch;
    // One cell more, so that rounding cannot omit a group.
    const double wide = reach + grid.pitch;
    const double end_y = move.y + move.length * move.direction_y;
    const double low = (std::min(move.y, end_y) - wide - grid.low_y) / width;
    const double high = (std::max(move.y, end_y) + wide - grid.low_y) / width;
    if (high < 0 || low >= rows_)
        return;
    for (int row = group_at(low, rows_); row <= group_at(high, rows_); ++row) {
        const double row_y = grid.low_y + row * width;
        const Span part = part_between(move, row_y - wide, row_y + width + wide);
        const double dx = move.length * move.direction_x;
        const auto [first, second] =
            std::minmax({move.x + part.low * dx, move.x + part.high * dx});
        const double left = (first - wide - grid.low_x) / width;
        const double right = (second + wide - grid.low_x) / width;
        if (right < 0 || left >= columns_)
            continue;
        for (int k = group_at(left, columns_); k <= group_at(right, columns_); ++k)
            visit(static_cast<std::size_t>(row) * columns_ + k);
    }
}

MoveBins::MoveBins(const StockGrid& grid, std::span<const SweptMove> moves, double reach,
                   std::size_t most_entries)
    : columns_{groups_across(grid.columns)},
      rows_{groups_across(grid.rows)},
      begins_(static_cast<std::size_t>(columns_) * rows_ + 1, 0)
{
    std::size_t entries = 0;
    for (const SweptMove& move : moves) {
        if (entries >= most_entries)
            break;
        for_each_group(grid, move, reach, [&](std::size_t group) {
            ++begins_[group];
            ++entries;
        });
        ++moves_;
    }
    // The counts become the ends of the groups. Filling the entries from the last move to
    // the first turns the ends into beginnings and keeps the moves in order.
    for (std::size_t group = 1; group < begins_.size(); ++group)
        begins_[group] += begins_[group - 1];
    entries_.resize(entries);
    for (std::size_t k = moves_; k-- > 0;)
        for_each_group(grid, moves[k], reach, [&](std::size_t group) {
            entries_[--begins_[group]] = static_cast<std::uint32_t>(k);
        });
}

}  // namespace endmill
