// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/detail/dexel_tile.h"

#include <algorithm>
#include <utility>

namespace endmill {
namespace {

DexelRays rays_of(const DexelStock& stock, int axis)
{
    return {.unit = stock.unit(),
            .direction = Vec3::Unit(axis),
            .length = stock.block().high[axis] - stock.block().low[axis],
            .dexels = {},
            .starts = {},
            .middle = Vec3::Zero(),
            .radius = 0};
}

std::size_t rays_along(int first, int all)
{
    return static_cast<std::size_t>(std::min(dexel_tile_side, all - first));
}

// From the lowest to the highest material of all rays; empty without material.
RayStretch material_of(const DexelRays& rays)
{
    RayStretch material{rays.length, 0};
    for (const Dexel& dexel : rays.dexels)
        if (!dexel.upper.empty())
            material = {std::min(material.from, dexel.upper.front().from * rays.unit),
                        std::max(material.to, dexel.upper.back().to * rays.unit)};
    return material;
}

// One chord for all rays.
EightWholeChords repeated(const EightWholeChords& chords, std::size_t ray)
{
    EightWholeChords all;
    all.may.from.fill(chords.may.from[ray]);
    all.may.to.fill(chords.may.to[ray]);
    all.sure.from.fill(chords.sure.from[ray]);
    all.sure.to.fill(chords.sure.to[ray]);
    all.is_grazing.fill(chords.is_grazing[ray]);
    return all;
}

bool is_any(const EightWhole& marks)
{
    std::int32_t sum = 0;
    for (const std::int32_t mark : marks)
        sum += mark;
    return sum > 0;
}

}  // namespace

DexelTile::DexelTile(const DexelStock& stock, int axis, int column, int row)
    : field_{stock.field(axis)},
      column_{column},
      row_{row},
      columns_{rays_along(column, field_.columns())},
      rows_{rays_along(row, field_.rows())},
      rays_{rays_of(stock, axis)},
      gaps_{columns_, rows_, stock.units(axis)},
      around_{}
{
    rays_.dexels.reserve(columns_ * rows_);
    rays_.starts.reserve(columns_ * rows_);
    for (int j = row; j < row + static_cast<int>(rows_); ++j)
        for (int i = column; i < column + static_cast<int>(columns_); ++i) {
            const auto upper = field_.upper(i, j);
            const auto lower = field_.lower(i, j);
            rays_.dexels.push_back(
                {{upper.begin(), upper.end()}, {lower.begin(), lower.end()}});
            rays_.starts.push_back(field_.start(i, j));
        }
    rays_.middle = (rays_.starts.front() + rays_.starts.back()) / 2;
    rays_.radius = (rays_.starts.front() - rays_.middle).norm();
    const int across = (axis + 1) % 3;
    const int along = (axis + 2) % 3;
    for (std::size_t k = 0; k < dexel_tile_side; ++k) {
        column_places_[k] = rays_.starts[std::min(k, columns_ - 1)][across];
        row_places_[k] = rays_.starts[first_ray(std::min(k, rows_ - 1))][along];
    }
    around_ = {{column_places_.front(), row_places_.front()},
               {column_places_.back(), row_places_.back()}};
}

const std::vector<RayChord>& DexelTile::chords_of(const ToolPiece& piece)
{
    chords_.clear();
    if (!material_)
        material_ = material_of(rays_);
    if (material_->from < material_->to)
        add_chords(rays_, piece, *material_, chords_);
    if (has_gaps_ && !chords_.empty()) {
        gaps_.store(rays_.dexels);
        has_gaps_ = false;
    }
    return chords_;
}

DexelTile::BodyDepth DexelTile::depth_in(const ToolPiece& body)
{
    BodyDepth found;
    for (const auto& [ray, chord] : chords_of(body)) {
        const Dexel& dexel = rays_.dexels[ray];
        found.depth = std::max(found.depth, length_within(dexel.lower, chord.sure));
        found.most_depth =
            std::max(found.most_depth, length_within(dexel.upper, chord.may));
    }
    return found;
}

DexelCut DexelTile::cut(const ToolPiece& piece)
{
    DexelCut done;
    for (const auto& [ray, chord] : chords_of(piece))
        done.add(cut_dexel(rays_.dexels[ray], chord));
    if (!chords_.empty())
        material_.reset();
    return done;
}

DexelCut DexelTile::cut(const ToolPiece& piece, const FixedAxisBallOnField& ball)
{
    has_gaps_ = true;
    material_.reset();
    std::span<const EightWholeChords> chords;
    if (ball.is_above(around_)) {
        chords = chords_above(ball);
    } else {
        const std::span rows = std::span{row_chords_}.first(rows_);
        ball.find_chords(column_places_, row_places_, rows);
        chords = rows;
    }
    DexelCut done = gaps_.cut(rays_.dexels, chords);
    for (std::size_t row = 0; row < rows_; ++row) {
        const EightWholeChords& of = chords.size() > 1 ? chords[row] : chords.front();
        if (is_any(of.is_grazing))
            done.add(cut_grazing(piece, row, of));
    }
    return done;
}

// Returns the chords of rays above the centres of the ball. They do not depend on the
// height, so that they are the same for all rows, or for all rays of a row.
std::span<const EightWholeChords> DexelTile::chords_above(
    const FixedAxisBallOnField& ball)
{
    if (ball.height() == 1) {
        row_chords_.front() = ball.chords_above(column_places_);
        return std::span{row_chords_}.first(1);
    }
    const EightWholeChords beside = ball.chords_above(row_places_);
    for (std::size_t row = 0; row < rows_; ++row)
        row_chords_[row] = repeated(beside, row);
    return std::span{row_chords_}.first(rows_);
}

// Cuts the rays of a row that graze the ball, one by one.
DexelCut DexelTile::cut_grazing(const ToolPiece& piece, std::size_t row,
                                const EightWholeChords& chords)
{
    DexelCut done;
    for (std::size_t i = 0; i < columns_; ++i) {
        if (chords.is_grazing[i] == 0)
            continue;
        chords_.clear();
        gaps_.store(rays_.dexels, first_ray(row) + i);
        add_chords_on_ray(rays_, piece, first_ray(row) + i, chords_);
        for (const auto& [ray, chord] : chords_)
            done.add(cut_dexel(rays_.dexels[ray], chord));
    }
    return done;
}

void DexelTile::move_to(std::vector<Dexel>& dexels)
{
    gaps_.store(rays_.dexels);
    for (std::size_t j = 0; j < rows_; ++j)
        for (std::size_t i = 0; i < columns_; ++i)
            dexels[(static_cast<std::size_t>(row_) + j) * field_.columns() + column_ +
                   i] = std::move(rays_.dexels[first_ray(j) + i]);
}

}  // namespace endmill
