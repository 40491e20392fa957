// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_removal.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>

#include "endmill/core/parallel.h"
#include "endmill/stock/detail/dexel_cut.h"
#include "endmill/stock/detail/dexel_tile.h"
#include "endmill/stock/detail/fixed_axis_ball.h"

namespace endmill {
namespace {

// What the moves do on the rays of one field, in units.
struct FieldMove {
    DexelCut cut;
    DexelTile::BodyDepth body;

    void add(const FieldMove& other)
    {
        cut.add(other.cut);
        body.depth = std::max(body.depth, other.body.depth);
        body.most_depth = std::max(body.most_depth, other.body.most_depth);
    }
};

// The fixed-axis moves of a ball among the cutters' pieces, on the rays of one field.
class FixedAxisBalls {
public:
    FixedAxisBalls(const ToolPieces& cutters, const DexelStock& stock, int axis)
        : number_(cutters.pieces().size(), -1)
    {
        for (std::size_t k = 0; k < number_.size(); ++k)
            if (const auto ball = fixed_axis_ball(cutters.pieces()[k])) {
                number_[k] = static_cast<std::int32_t>(balls_.size());
                balls_.emplace_back(*ball, axis, stock);
            }
    }

    // The move of a piece; null if it is none.
    const FixedAxisBallOnField* of(std::uint32_t piece) const
    {
        const std::int32_t number = number_[piece];
        return number < 0 ? nullptr : &balls_[static_cast<std::size_t>(number)];
    }

private:
    std::vector<std::int32_t> number_;
    std::vector<FixedAxisBallOnField> balls_;
};

// All that cuts the rays of one field.
struct FieldMotions {
    const DexelMotions& all;
    FixedAxisBalls balls;
};

// A piece of a cutter or a body, by its place in the order of cutting. Of the same order,
// bodies come first.
class OrderedPiece {
public:
    OrderedPiece(std::int32_t order, bool is_cutter, std::uint32_t number)
        : key_{static_cast<std::uint64_t>(order) << 32U |
               std::uint64_t{is_cutter} << 31U | number}
    {
    }

    bool is_cutter() const { return (key_ >> 31U & 1U) != 0; }
    std::uint32_t number() const { return key_ & 0x7fffffffU; }

    bool operator<(const OrderedPiece& other) const { return key_ < other.key_; }

private:
    std::uint64_t key_;
};

// The tiles of a field, in groups that look for near pieces together.
class TileGroups {
public:
    TileGroups(const DexelStock& stock, int axis)
        : stock_{stock},
          axis_{axis},
          across_{count(stock.field(axis).columns())},
          along_{count(stock.field(axis).rows())}
    {
    }

    std::size_t count() const { return across_ * along_; }

    std::vector<DexelTile> tiles(std::size_t group) const
    {
        const DexelField& field = stock_.field(axis_);
        const int first_column = static_cast<int>(group % across_) * side;
        const int first_row = static_cast<int>(group / across_) * side;
        const int last_column = std::min(first_column + side, field.columns());
        const int last_row = std::min(first_row + side, field.rows());
        std::vector<DexelTile> tiles;
        tiles.reserve(static_cast<std::size_t>(tiles_across) * tiles_across);
        for (int row = first_row; row < last_row; row += dexel_tile_side)
            for (int column = first_column; column < last_column;
                 column += dexel_tile_side)
                tiles.emplace_back(stock_, axis_, column, row);
        return tiles;
    }

private:
    static constexpr int tiles_across = 4;
    static constexpr int side = tiles_across * dexel_tile_side;

    static std::size_t count(int rays)
    {
        return static_cast<std::size_t>((rays + side - 1) / side);
    }

    const DexelStock& stock_;
    int axis_;
    std::size_t across_;
    std::size_t along_;
};

// Returns the pieces that come near a group of tiles, in the order of cutting.
std::vector<OrderedPiece> pieces_near(std::span<const DexelTile> tiles,
                                      const DexelMotions& motions)
{
    const Vec3 middle = (tiles.front().middle() + tiles.back().middle()) / 2;
    const Vec3 end = middle + (tiles.front().end() - tiles.front().middle());
    double radius = 0;
    for (const DexelTile& tile : tiles)
        radius = std::max(radius, (tile.middle() - middle).norm() + tile.radius());
    std::vector<OrderedPiece> near;
    const auto add = [&](const ToolPieces& pieces, bool is_cutter) {
        for (const std::uint32_t number : pieces.near_segment(middle, end, radius))
            near.emplace_back(pieces.pieces()[number].order, is_cutter, number);
    };
    add(motions.bodies, false);
    add(motions.cutters, true);
    std::ranges::sort(near, std::less{});
    return near;
}

// Cuts the rays of one tile by pieces.
// \param moves receives what they do, by the number of the point.
void cut_tile(DexelTile& tile, std::span<const OrderedPiece> near,
              const FieldMotions& motions, std::vector<FieldMove>& moves)
{
    for (const OrderedPiece& one : near) {
        const ToolPieces& of = one.is_cutter() ? motions.all.cutters : motions.all.bodies;
        const FixedAxisBallOnField* ball =
            one.is_cutter() ? motions.balls.of(one.number()) : nullptr;
        const bool is_near =
            ball ? tile.is_reached(*ball)
                 : of.is_near(one.number(), tile.middle(), tile.end(), tile.radius());
        if (!is_near)
            continue;
        const ToolPiece& piece = of.pieces()[one.number()];
        FieldMove& move = moves[static_cast<std::size_t>(piece.point)];
        if (ball)
            move.cut.add(tile.cut(piece, *ball));
        else if (one.is_cutter())
            move.cut.add(tile.cut(piece));
        else
            move.add({{}, tile.depth_in(piece)});
    }
}

// Removes the material on the rays of one field.
std::vector<FieldMove> cut_field(DexelStock& stock, int axis, const DexelMotions& motions,
                                 const std::function<void(double)>& progress)
{
    DexelField& field = stock.field(axis);
    const TileGroups groups{stock, axis};
    std::vector<Dexel> dexels(static_cast<std::size_t>(field.columns()) * field.rows());
    std::vector<FieldMove> moves(motions.points);
    const FieldMotions on_field{motions, {motions.cutters, stock, axis}};
    std::mutex adding;
    std::atomic<std::size_t> done = 0;
    parallel_for(groups.count(), [&](std::size_t begin, std::size_t end) {
        std::vector<FieldMove> own(motions.points);
        for (std::size_t k = begin; k < end; ++k) {
            std::vector<DexelTile> tiles = groups.tiles(k);
            const std::vector<OrderedPiece> near = pieces_near(tiles, motions);
            for (DexelTile& tile : tiles) {
                cut_tile(tile, near, on_field, own);
                tile.move_to(dexels);
            }
            const auto finished = static_cast<double>(++done);
            if (progress)
                progress((axis + finished / static_cast<double>(groups.count())) / 3);
        }
        const std::scoped_lock lock{adding};
        for (std::size_t k = 0; k < moves.size(); ++k)
            moves[k].add(own[k]);
    });
    field.assign(dexels);
    return moves;
}

}  // namespace

DexelRemoval remove_from_dexels(DexelStock& stock, const DexelMotions& motions,
                                const std::function<void(double)>& progress)
{
    DexelRemoval removal;
    removal.moves.resize(motions.points);
    std::array<double, 3> removed{};
    for (int axis = 0; axis < 3; ++axis) {
        const DexelVolume before = dexel_volume(stock, axis);
        const std::vector<FieldMove> moves = cut_field(stock, axis, motions, progress);
        const double unit = stock.unit();
        const double volume = unit * stock.field(axis).cell_area();
        for (std::size_t k = 0; k < moves.size(); ++k) {
            DexelMove& move = removal.moves[k];
            move.removed += static_cast<double>(moves[k].cut.removed) * volume / 6;
            move.deepest =
                std::max(move.deepest, static_cast<double>(moves[k].cut.deepest) * unit);
            move.most_deep = std::max(move.most_deep,
                                      static_cast<double>(moves[k].cut.most_deep) * unit);
            move.body_depth = std::max(move.body_depth,
                                       static_cast<double>(moves[k].body.depth) * unit);
            move.most_body_depth =
                std::max(move.most_body_depth,
                         static_cast<double>(moves[k].body.most_depth) * unit);
        }
        const DexelVolume after = dexel_volume(stock, axis);
        const double most = before.upper - after.lower;
        const double least = before.lower - after.upper;
        removed[std::size_t(axis)] = (most + least) / 2;
        removal.removed += (most + least) / 6;
        removal.bound += (most - least) / 6;
    }
    removal.spread =
        *std::ranges::max_element(removed) - *std::ranges::min_element(removed);
    return removal;
}

}  // namespace endmill
