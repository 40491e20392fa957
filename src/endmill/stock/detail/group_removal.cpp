// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/group_removal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>

#include "endmill/core/parallel.h"
#include "endmill/stock/detail/tile_clearance.h"

// A group of 4 by 4 tiles is processed by one thread.
// 1. Its moves are taken in batches of 256. `may_touch` discards the moves that pass
//    clear of a plane above the whole group.
// 2. For each tile, the moves of the batch are tested in blocks of eight against the
//    tile's own plane. The plane is fitted again after a cut, because the tile is lower
//    then.
// 3. The remaining moves are cut exactly (`cut_tile`), with the depths of shank and
//    holder before and after the cut.
// Results of the same move from different groups are combined by atomic additions of
// integers and atomic maxima, which do not depend on the order.

namespace endmill {
namespace {

// Cutter and cylinders are narrowed by this share of their radius for the tests of
// forbidden contacts. A cell on the rim, where rounding decides, then does not count. The
// share is far above rounding errors and far below any clearance.
constexpr double rim_share = 1e-9;
// Number of moves that are tested against a tile before its plane is fitted again.
constexpr int moves_at_a_time = 8;
constexpr int tiles_in_group = MoveBins::group_side * MoveBins::group_side;

// Raises a shared number to at least `value`.
void raise_to(double& shared, double value)
{
    const std::atomic_ref<double> atomic{shared};
    double known = atomic.load(std::memory_order_relaxed);
    while (known < value &&
           !atomic.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
}

// A tile of the current group.
struct WorkedTile {
    HeightStock::Tile heights;
    TilePlace place;
    UpperPlane top;
    bool is_lowered = false;  // since `top` was fitted
};

// The tiles of one group and their results.
class Group {
public:
    Group(HeightStock& stock, std::span<const SweptMove> moves, const SweepingTool& tool,
          PartOfRemoval& part)
        : stock_{stock},
          moves_{moves},
          tool_{tool},
          part_{part},
          cutter_disc_{tool.cutter.flat_radius(), tool.cutter.corner_radius(),
                       tool.cutter.corner_radius()}
    {
        tiles_.reserve(tiles_in_group);
    }

    // Cuts the group in this column and row by its moves, in order.
    void cut_group(int column, int row, std::span<const std::uint32_t> numbers)
    {
        collect_tiles(column, row);
        for (std::size_t next = 0; next < numbers.size() && !tiles_.empty();) {
            batch_.count = 0;
            for (; next < numbers.size() && batch_.count < MoveBatch::capacity; ++next)
                batch_.add(moves_[numbers[next]], numbers[next]);
            discard_clear_moves();
            for (WorkedTile& tile : tiles_)
                cut(tile);
            add_batch();
        }
    }

private:
    // Collects the tiles of the group that have material.
    void collect_tiles(int column, int row)
    {
        constexpr int side = MoveBins::group_side;
        tiles_.clear();
        const int last_row = std::min(stock_.tile_rows(), (row + 1) * side);
        const int last_column = std::min(stock_.tile_columns(), (column + 1) * side);
        for (int j = row * side; j < last_row; ++j)
            for (int i = column * side; i < last_column; ++i) {
                const HeightStock::Tile heights = stock_.tile(i, j);
                const double bottom = stock_.grid().bottom_z;
                if (std::ranges::all_of(heights, [&](double z) { return z <= bottom; }))
                    continue;
                const TilePlace place = tile_place(stock_.grid(), i, j);
                tiles_.push_back({heights, place, upper_plane(heights, place)});
            }
    }

    // Discards the moves of the batch that pass clear of all tiles.
    void discard_clear_moves()
    {
        tops_.clear();
        for (WorkedTile& tile : tiles_)
            tops_.push_back(current_plane(tile));
        find_touches(common_upper_plane(tops_), {0, batch_.count});
        batch_.keep(touches_.data());
    }

    // Returns the plane above a tile, fitted again if the tile was lowered.
    static const UpperPlane& current_plane(WorkedTile& tile)
    {
        if (tile.is_lowered) {
            tile.top = upper_plane(tile.heights, tile.place);
            tile.is_lowered = false;
        }
        return tile.top;
    }

    // Marks the moves of the range that may touch the stock below `top` with any part of
    // the tool.
    void find_touches(const UpperPlane& top, MoveRange range)
    {
        may_touch(top, batch_, cutter_disc_, range, touches_.data());
        std::array<std::uint8_t, MoveBatch::capacity> meets;
        for (const BodyCylinder& body : tool_.body) {
            may_touch(top, batch_, {body.radius, 0, body.above}, range, meets.data());
            for (int k = range.first; k < range.last; ++k)
                touches_[k] |= meets[k];
        }
    }

    // Cuts a tile by the moves of the batch.
    void cut(WorkedTile& tile)
    {
        for (int first = 0; first < batch_.count; first += moves_at_a_time) {
            const int last = std::min(batch_.count, first + moves_at_a_time);
            find_touches(current_plane(tile), {first, last});
            for (int k = first; k < last; ++k)
                if (touches_[k])
                    cut(tile, static_cast<std::size_t>(k));
        }
    }

    // Cuts a tile by move `k` of the batch.
    void cut(WorkedTile& tile, std::size_t k)
    {
        const std::uint32_t number = batch_.number[k];
        const SweptMove& move = moves_[number];
        double body_depth = 0;
        for (const BodyCylinder& body : tool_.body)
            if (body.radius > tool_.cutter.radius())
                body_depth =
                    std::max(body_depth,
                             body_depth_on_arrival(tile.heights, tile.place, body, move));
        std::optional<double> rapid_depth;
        if (move.is_rapid) {
            std::array<double, HeightStock::tile_size> copy;
            std::ranges::copy(tile.heights, copy.begin());
            rapid_depth =
                cut_tile(HeightStock::Tile{copy}, tile.place, tool_.narrowed_cutter, move)
                    .deepest;
        }
        const TileCut cut = cut_tile(tile.heights, tile.place, tool_.cutter, move);
        for (const BodyCylinder& body : tool_.body)
            body_depth = std::max(
                body_depth, endmill::body_depth(tile.heights, tile.place, body, move));
        if (body_depth > 0)
            raise_to(part_.body_depths[number], body_depth);
        if (cut.deepest > 0)
            add(tile, k, {cut.depths, rapid_depth.value_or(cut.deepest)});
    }

    // Adds the cut of a tile to the cut of a move of the batch.
    void add(WorkedTile& tile, std::size_t k, const TileCut& cut)
    {
        tile.is_lowered = true;
        const double pitch = stock_.grid().pitch;
        volumes_[k] += std::llround(cut.depths * (pitch * pitch) / part_.unit);
        deepest_[k] = std::max(deepest_[k], cut.deepest);
    }

    // Adds the cuts of the batch to the results of its moves, which the groups share.
    void add_batch()
    {
        for (std::size_t k = 0; k < static_cast<std::size_t>(batch_.count); ++k) {
            if (volumes_[k] != 0)
                std::atomic_ref<std::int64_t>{part_.volumes[batch_.number[k]]}.fetch_add(
                    volumes_[k], std::memory_order_relaxed);
            if (deepest_[k] > 0)
                raise_to(part_.deepest[batch_.number[k]], deepest_[k]);
        }
        volumes_.fill(0);
        deepest_.fill(0);
    }

    HeightStock& stock_;
    std::span<const SweptMove> moves_;
    const SweepingTool& tool_;
    PartOfRemoval& part_;
    SweptDisc cutter_disc_;
    std::vector<WorkedTile> tiles_;
    std::vector<UpperPlane> tops_;
    MoveBatch batch_;
    std::array<std::uint8_t, MoveBatch::capacity> touches_;
    // Cuts of the moves of the batch in all tiles: in units of volume, and in mm.
    std::array<std::int64_t, MoveBatch::capacity> volumes_{};
    std::array<double, MoveBatch::capacity> deepest_{};
};

// Returns the groups over which a move passes.
std::vector<std::size_t> groups_with_moves(const MoveBins& bins)
{
    std::vector<std::size_t> groups;
    const std::size_t all =
        static_cast<std::size_t>(bins.group_columns()) * bins.group_rows();
    for (std::size_t group = 0; group < all; ++group)
        if (!bins.over(group).empty())
            groups.push_back(group);
    return groups;
}

}  // namespace

SweepingTool sweeping_tool(const Cutter& cutter, std::span<const ToolCylinder> body)
{
    constexpr double narrowed = 1 - rim_share;
    const Cutter narrowed_cutter{narrowed * cutter.radius(),
                                 narrowed * cutter.corner_radius()};
    SweepingTool tool{cutter, narrowed_cutter, {}, cutter.radius()};
    for (const ToolCylinder& cylinder : body) {
        tool.body.push_back({narrowed * cylinder.diameter / 2, cylinder.from});
        tool.reach = std::max(tool.reach, cylinder.diameter / 2);
    }
    return tool;
}

PartOfRemoval remove_part(HeightStock& stock, std::span<const SweptMove> moves,
                          const MoveBins& bins, const SweepingTool& tool, double unit)
{
    PartOfRemoval part{unit, std::vector<std::int64_t>(moves.size(), 0),
                       std::vector<double>(moves.size(), 0),
                       std::vector<double>(moves.size(), 0)};
    const std::vector<std::size_t> groups = groups_with_moves(bins);
    parallel_for(groups.size(), [&](std::size_t begin, std::size_t end) {
        Group group{stock, moves, tool, part};
        for (std::size_t k = begin; k < end; ++k) {
            const int column = static_cast<int>(groups[k] % bins.group_columns());
            const int row = static_cast<int>(groups[k] / bins.group_columns());
            group.cut_group(column, row, bins.over(groups[k]));
        }
    });
    return part;
}

}  // namespace endmill
