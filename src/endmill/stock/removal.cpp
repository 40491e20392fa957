// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/removal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"
#include "endmill/stock/detail/group_removal.h"
#include "endmill/stock/detail/move_bins.h"
#include "endmill/stock/detail/removable_path.h"
#include "endmill/stock/detail/swept_move.h"

// The removal runs in parts, to bound the memory.
// 1. `moves_from` prepares the next moves of the path; there are more of them per part
//    the more cells there are.
// 2. `MoveBins` sorts them by the groups of tiles they pass over and may take fewer.
// 3. `remove_part` cuts all groups on all threads, each with its moves in order.
// 4. `add_part` adds volumes and depths of the part to the result.
// Volumes are integers in a unit that is a power of two, so their sums are exact and do
// not depend on the order of threads.

namespace endmill {
namespace {

// Number of moves per part, and of pairs of a move and a group. They take about one byte
// per cell and are enough to keep all threads busy.
struct PartSize {
    std::size_t moves;
    std::size_t entries;
};

PartSize part_size(const StockGrid& grid)
{
    const std::size_t cells = static_cast<std::size_t>(grid.columns) * grid.rows;
    return {std::max<std::size_t>(4096, cells / 128),
            std::max<std::size_t>(std::size_t{1} << 17, cells / 8)};
}

// Checks the cylinders of the tool.
void require_sound(const RemovalOptions& options)
{
    for (const ToolCylinder& cylinder : options.body)
        require(cylinder.diameter > 0 && std::isfinite(cylinder.diameter) &&
                    std::isfinite(cylinder.from),
                "remove_along: need cylinders with a positive, finite diameter");
}

// Returns at most `count` moves of the path from number `first` on. The first point, if
// it cuts at all, is a move without length.
std::vector<SweptMove> moves_from(const ToolPath& path, std::size_t first,
                                  std::size_t count)
{
    const std::size_t last = std::min(path.points.size(), first + count);
    std::vector<SweptMove> moves;
    moves.reserve(last - first);
    for (std::size_t k = first; k < last; ++k) {
        const Vec3& to = path.points[k].location.tip;
        moves.push_back(swept_move(k == 0 ? to : path.points[k - 1].location.tip, to));
        moves.back().is_continued = k > 1 || (k == 1 && cuts_at_start(path));
        moves.back().is_rapid = path.points[k].move == Move::Rapid;
    }
    return moves;
}

// Returns the unit of volume: a power of two such that the stock's volume is less than
// 2^61 units. The sum of all parts is then exact in 64 bits.
double volume_unit(const HeightStock& stock)
{
    const double volume = stock_volume(stock);
    return volume > 0 ? std::ldexp(1, std::ilogb(volume) - 60) : 1;
}

// Adds a move with this depth to the count.
void add_move(MoveCount& moves, std::size_t number, double depth)
{
    ++moves.count;
    if (!moves.first)
        moves.first = number;
    moves.deepest = std::max(moves.deepest, depth);
}

// Adds the result of a part whose first move has number `first`.
void add_part(Removal& removal, const PartOfRemoval& part, const ToolPath& path,
              std::size_t first)
{
    for (std::size_t k = 0; k < part.volumes.size(); ++k) {
        const std::size_t number = first + k;
        const double depth = part.deepest[k];
        removal.removed[number] = static_cast<double>(part.volumes[k]) * part.unit;
        removal.deepest[number] = depth;
        const bool cuts = depth > touching_depth;
        if (!cuts && number > 0)
            ++removal.air_moves;
        if (cuts && path.points[number].move == Move::Rapid)
            add_move(removal.rapid_cuts, number, depth);
        if (part.body_depths[k] > touching_depth)
            add_move(removal.collisions, number, part.body_depths[k]);
    }
}

// Length of the move to a point, mm.
double length_to(const ToolPath& path, std::size_t number)
{
    if (number == 0)
        return 0;
    return (path.points[number].location.tip - path.points[number - 1].location.tip)
        .norm();
}

}  // namespace

Removal remove_along(HeightStock& stock, const ToolPath& path, const Cutter& cutter,
                     const RemovalOptions& options)
{
    require_removable(path);
    require_sound(options);
    Removal removal;
    removal.removed.assign(path.points.size(), 0);
    removal.deepest.assign(path.points.size(), 0);
    const SweepingTool tool = sweeping_tool(cutter, options.body);
    const PartSize size = part_size(stock.grid());
    const double unit = volume_unit(stock);
    std::int64_t total = 0;
    std::size_t first = !path.points.empty() && !cuts_at_start(path) ? 1 : 0;
    while (first < path.points.size()) {
        const std::vector<SweptMove> moves = moves_from(path, first, size.moves);
        const MoveBins bins{stock.grid(), moves, tool.reach, size.entries};
        const PartOfRemoval part =
            remove_part(stock, {moves.data(), bins.moves()}, bins, tool, unit);
        add_part(removal, part, path, first);
        for (const std::int64_t volume : part.volumes)
            total += volume;
        first += bins.moves();
    }
    removal.total = static_cast<double>(total) * unit;
    removal.left = height_range(stock);
    return removal;
}

std::optional<double> removal_rate(const Removal& removal, const ToolPath& path,
                                   std::size_t number)
{
    if (path.points[number].move == Move::Rapid)
        return std::nullopt;
    const auto feed = path.points[number].conditions.feed_mm_per_min;
    const double length = length_to(path, number);
    if (!feed || !(length > 0))
        return std::nullopt;
    const double rate = removal.removed[number] / length * *feed;
    return std::isfinite(rate) ? std::optional{rate} : std::nullopt;
}

std::optional<RemovalRates> removal_rates(const Removal& removal, const ToolPath& path)
{
    double greatest = 0;
    double volume = 0;
    double time_min = 0;
    for (std::size_t k = 1; k < path.points.size(); ++k)
        if (const auto rate = removal_rate(removal, path, k)) {
            greatest = std::max(greatest, *rate);
            volume += removal.removed[k];
            time_min += length_to(path, k) / *path.points[k].conditions.feed_mm_per_min;
        }
    if (!(time_min > 0) || !std::isfinite(volume / time_min))
        return std::nullopt;
    return RemovalRates{greatest, volume / time_min};
}

}  // namespace endmill
