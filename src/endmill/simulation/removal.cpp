// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/simulation/removal.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "endmill/core/error.h"
#include "endmill/core/parallel.h"
#include "endmill/simulation/group_removal.h"
#include "endmill/simulation/move_bins.h"
#include "endmill/simulation/swept_move.h"

namespace endmill {
namespace {

// Differences of such coordinates still tell a thousandth of a millimetre.
constexpr double largest_coordinate = 1e9;  // mm
// The axis is that of the grid but for the rounding of a unit vector.
constexpr double axis_slack = 1e-9;
// Moves that are taken apart at a time, and entries of a move and a group of tiles: they
// bound the memory, and are enough to keep all threads busy.
constexpr std::size_t most_moves = 8192;
constexpr std::size_t most_entries = std::size_t{1} << 18;

void require_sound(const ToolPath& path, const RemovalOptions& options)
{
    for (const PathPoint& point : path.points) {
        const Vec3& tip = point.location.tip;
        require(tip.allFinite() && tip.cwiseAbs().maxCoeff() <= largest_coordinate,
                "remove_along: a tip is not within 1e9 mm");
        if (!((point.location.axis - Vec3::UnitZ()).norm() <= axis_slack))
            throw GeometryError{
                "the tool axis of pass " + std::to_string(point.pass) + ", point " +
                std::to_string(point.point) +
                " is not +z: removal of five-axis paths is not supported yet"};
    }
    for (const ToolCylinder& cylinder : options.body)
        require(cylinder.diameter > 0 && std::isfinite(cylinder.from),
                "remove_along: a cylinder of the tool has no diameter");
}

// Moves first, first + 1, … of the path, at most `most_moves`. The first point is a move
// that stays in place, if it cuts at all.
std::vector<SweptMove> moves_from(const ToolPath& path, std::size_t first)
{
    const std::size_t last = std::min(path.points.size(), first + most_moves);
    std::vector<SweptMove> moves;
    moves.reserve(last - first);
    for (std::size_t k = first; k < last; ++k) {
        const Vec3& to = path.points[k].location.tip;
        moves.push_back(swept_move(k == 0 ? to : path.points[k - 1].location.tip, to));
    }
    return moves;
}

bool cuts_at_start(const ToolPath& path)
{
    const Move move = path.points.front().move;
    return move == Move::Plunge || move == Move::Cut;
}

// A power of two of which the volume of the stock is at most 2^61: the sum of all parts
// is exact in 64 bits.
double volume_unit(const HeightStock& stock)
{
    const double volume = stock_volume(stock);
    return volume > 0 ? std::ldexp(1, std::ilogb(volume) - 60) : 1;
}

void count(MoveCount& moves, std::size_t number, double depth)
{
    ++moves.count;
    if (!moves.first)
        moves.first = number;
    moves.deepest = std::max(moves.deepest, depth);
}

// Adds what a part of the moves did, the first of them number `first`.
void add_part(Removal& removal, const PartOfRemoval& part, const ToolPath& path,
              std::size_t first)
{
    for (std::size_t k = 0; k < part.volumes.size(); ++k) {
        const std::size_t number = first + k;
        const double depth = part.deepest[k];
        removal.removed[number] = static_cast<double>(part.volumes[k]) * part.unit;
        removal.deepest[number] = depth;
        const bool cuts = depth > least_cut_depth;
        if (!cuts && number > 0)
            ++removal.air_moves;
        if (cuts && path.points[number].move == Move::Rapid)
            count(removal.rapid_cuts, number, depth);
        if (part.body_depths[k] > least_cut_depth)
            count(removal.collisions, number, part.body_depths[k]);
    }
}

}  // namespace

Removal remove_along(HeightStock& stock, const ToolPath& path, const Cutter& cutter,
                     const RemovalOptions& options)
{
    require_sound(path, options);
    Removal removal;
    removal.removed.assign(path.points.size(), 0);
    removal.deepest.assign(path.points.size(), 0);
    const SweepingTool tool = sweeping_tool(cutter, options.body);
    const double unit = volume_unit(stock);
    std::int64_t total = 0;
    std::size_t first = !path.points.empty() && !cuts_at_start(path) ? 1 : 0;
    while (first < path.points.size()) {
        const std::vector<SweptMove> moves = moves_from(path, first);
        const MoveBins bins{stock.grid(), moves, tool.reach, most_entries};
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

}  // namespace endmill
