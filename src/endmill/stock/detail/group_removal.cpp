// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/group_removal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <optional>

#include "endmill/core/parallel.h"
#include "endmill/stock/detail/tile_clearance.h"

namespace endmill {
namespace {

// Of a radius: what must not touch is narrower by this, so that a cell upon the rim, where
// rounding decides, does not count. Far above rounding, and below any clearance.
constexpr double rim_share = 1e-9;
// Moves that are compared with a tile at a time: then its plane is laid anew.
constexpr int moves_at_a_time = 8;
constexpr int tiles_in_group = MoveBins::group_side * MoveBins::group_side;

void raise_to(double& shared, double value)
{
    const std::atomic_ref<double> atomic{shared};
    double known = atomic.load(std::memory_order_relaxed);
    while (known < value &&
           !atomic.compare_exchange_weak(known, value, std::memory_order_relaxed)) {
    }
}

// A tile of the group at hand.
struct WorkedTile {
    HeightStock::Tile heights;
    TilePlace place;
    TileTop top;
    bool is_lowered = false;  // since `top` was laid
};

// The tiles of one group, and what the moves over them find there.
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

    // The group in this column and row, with its moves in order.
    void work_on(int column, int row, std::span<const std::uint32_t> numbers)
    {
        enter(column, row);
        for (std::size_t next = 0; next < numbers.size() && !tiles_.empty();) {
            batch_.count = 0;
            for (; next < numbers.size() && batch_.count < MoveBatch::capacity; ++next)
                batch_.add(moves_[numbers[next]], numbers[next]);
            leave_out_clear_moves();
            for (WorkedTile& tile : tiles_)
                work_on(tile);
        }
    }

private:
    // Tiles without material are left out.
    void enter(int column, int row)
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
                tiles_.push_back({heights, place, tile_top(heights, place)});
            }
    }

    // Those that pass clear over all tiles.
    void leave_out_clear_moves()
    {
        tops_.clear();
        for (WorkedTile& tile : tiles_)
            tops_.push_back(current_top(tile));
        find_touches(common_top(tops_), {0, batch_.count});
        batch_.keep(touches_.data());
    }

    static const TileTop& current_top(WorkedTile& tile)
    {
        if (tile.is_lowered) {
            tile.top = tile_top(tile.heights, tile.place);
            tile.is_lowered = false;
        }
        return tile.top;
    }

    // Which moves of the range may touch the stock below `top`, with any part of the
    // tool.
    void find_touches(const TileTop& top, MoveRange range)
    {
        may_touch(top, batch_, cutter_disc_, range, touches_.data());
        std::array<std::uint8_t, MoveBatch::capacity> meets;
        for (const BodyCylinder& body : tool_.body) {
            may_touch(top, batch_, {body.radius, 0, body.above}, range, meets.data());
            for (int k = range.first; k < range.last; ++k)
                touches_[k] |= meets[k];
        }
    }

    void work_on(WorkedTile& tile)
    {
        for (int first = 0; first < batch_.count; first += moves_at_a_time) {
            const int last = std::min(batch_.count, first + moves_at_a_time);
            find_touches(current_top(tile), {first, last});
            for (int k = first; k < last; ++k)
                if (touches_[k])
                    work_on(tile, batch_.number[k]);
        }
    }

    void work_on(WorkedTile& tile, std::uint32_t number)
    {
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
                cut_tile(HeightStock::Tile{copy}, tile.place, tool_.slim_cutter, move)
                    .deepest;
        }
        const TileCut cut = cut_tile(tile.heights, tile.place, tool_.cutter, move);
        for (const BodyCylinder& body : tool_.body)
            body_depth = std::max(
                body_depth, endmill::body_depth(tile.heights, tile.place, body, move));
        if (body_depth > 0)
            raise_to(part_.body_depths[number], body_depth);
        if (cut.deepest > 0)
            add(tile, number, {cut.depths, rapid_depth.value_or(cut.deepest)});
    }

    void add(WorkedTile& tile, std::uint32_t number, const TileCut& cut)
    {
        tile.is_lowered = true;
        const double pitch = stock_.grid().pitch;
        const std::atomic_ref<std::int64_t> volume{part_.volumes[number]};
        volume.fetch_add(std::llround(cut.depths * (pitch * pitch) / part_.unit),
                         std::memory_order_relaxed);
        raise_to(part_.deepest[number], cut.deepest);
    }

    HeightStock& stock_;
    std::span<const SweptMove> moves_;
    const SweepingTool& tool_;
    PartOfRemoval& part_;
    SweptDisc cutter_disc_;
    std::vector<WorkedTile> tiles_;
    std::vector<TileTop> tops_;
    MoveBatch batch_;
    std::array<std::uint8_t, MoveBatch::capacity> touches_;
};

// The groups over which a move passes.
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
    constexpr double slim = 1 - rim_share;
    const Cutter slim_cutter{slim * cutter.radius(), slim * cutter.corner_radius()};
    SweepingTool tool{cutter, slim_cutter, {}, cutter.radius()};
    for (const ToolCylinder& cylinder : body) {
        tool.body.push_back({slim * cylinder.diameter / 2, cylinder.from});
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
            group.work_on(column, row, bins.over(groups[k]));
        }
    });
    return part;
}

}  // namespace endmill
