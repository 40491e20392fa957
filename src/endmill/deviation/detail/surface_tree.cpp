// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/surface_tree.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/surface/detail/sampling_levels.h"
#include "endmill/surface/sampling.h"

// Each patch is split into pieces of at most 16 by 16 cells. A piece has a tangent disc
// and a box, computed from its four corners and a bound on the second derivatives, so its
// triangles need not exist. The boxes are grouped by fours into the levels of a tree. A
// query descends into near boxes first; only when a piece's disc may contain a nearer
// place are its triangles made (`sample`), once (`Once`).

namespace endmill {
namespace {

// Cells along a side of a piece. Making that many triangles takes about as long as a
// hundred queries.
constexpr int most_cells = 16;
// Rounding error of a point between others, as a share of the largest coordinate.
constexpr double rounding_share = 1e-14;
// Boxes per box of the level above.
constexpr std::size_t children = 4;

// Greatest number of halvings of a patch for bounds of its second derivatives.
constexpr int most_halvings = 4;

// Returns the number of halvings for which a piece lies in one of the bounded parts.
int halvings_of(int level)
{
    constexpr int level_of_piece = 4;  // of most_cells
    static_assert(1 << level_of_piece == most_cells);
    return std::clamp(level - level_of_piece, 0, most_halvings);
}

}  // namespace

SurfaceTree::SurfaceTree(std::span<const Surface> surfaces, double chord_tolerance)
{
    double triangles = 0;
    for (const Surface& surface : surfaces) {
        const SamplingLevels levels{surface, chord_tolerance};
        chord_error_ = std::max(chord_error_, levels.chord_error_mm());
        triangles += levels.triangles();
        if (triangles > static_cast<double>(most_sampled_triangles))
            throw LimitError{"the part would need about " + to_text(triangles) +
                             " triangles or more for a chord error of " +
                             to_text(chord_tolerance) + " mm; expected at most " +
                             std::to_string(most_sampled_triangles) +
                             "; a coarser resolution needs fewer"};
        for (int j = 0; j < surface.patches(Parameter::V); ++j)
            for (int i = 0; i < surface.patches(Parameter::U); ++i) {
                const auto [level_u, level_v] = levels.patch(i, j);
                add_patch({&surface, i, j, level_u, level_v});
            }
    }
    samples_.resize(pieces_.size());
    add_upper_boxes();
}

Vec3 SurfaceTree::Cells::point(int u, int v) const
{
    const auto parameter = [](std::span<const double> breaks, int patch, int part,
                              int level) {
        return std::lerp(breaks[patch], breaks[patch + 1], std::ldexp(part, -level));
    };
    return surface
        ->jet_in_patch(column, row,
                       parameter(surface->breaks(Parameter::U), column, u, level_u),
                       parameter(surface->breaks(Parameter::V), row, v, level_v))
        .point;
}

std::vector<Vec3> SurfaceTree::Cells::points() const
{
    const auto parameters = [](int low, int high, int level) {
        std::vector<double> at;
        for (int part = low; part <= high; ++part)
            at.push_back(std::ldexp(part, -level));
        return at;
    };
    return surface->patch(column, row)
        .places(parameters(low_u, high_u, level_u), parameters(low_v, high_v, level_v));
}

// Splits a patch into pieces. The second derivatives are bounded on parts of the patch,
// because one bound of the whole patch would be far too wide for most pieces.
void SurfaceTree::add_patch(const Cells& whole)
{
    const Halvings halvings{halvings_of(whole.level_u), halvings_of(whole.level_v)};
    const std::vector<BendBounds> bounds =
        bend_bounds(whole.surface->patch(whole.column, whole.row), halvings);
    add(whole, {halvings, bounds});
}

const BendBounds& SurfaceTree::Bounds::of(const Cells& cells) const
{
    const auto column =
        static_cast<std::size_t>(cells.low_u >> (cells.level_u - halvings.u));
    const auto row =
        static_cast<std::size_t>(cells.low_v >> (cells.level_v - halvings.v));
    return parts[(row << halvings.u) + column];
}

// Splits the cells into pieces; the halves of a piece are consecutive.
void SurfaceTree::add(const Cells& cells, const Bounds& bounds)
{
    const int count_u = cells.high_u - cells.low_u;
    const int count_v = cells.high_v - cells.low_v;
    if (std::max(count_u, count_v) > most_cells) {
        Cells low = cells;
        Cells high = cells;
        if (count_u >= count_v)
            low.high_u = high.low_u = cells.low_u + count_u / 2;
        else
            low.high_v = high.low_v = cells.low_v + count_v / 2;
        add(low, bounds);
        add(high, bounds);
        return;
    }
    const std::array<Vec3, 4> corners{
        cells.point(cells.low_u, cells.low_v), cells.point(cells.high_u, cells.low_v),
        cells.point(cells.high_u, cells.high_v), cells.point(cells.low_u, cells.high_v)};
    Box box{corners[0], corners[0]};
    TangentDisc disc = tangent_disc(corners);
    for (const Vec3& corner : corners) {
        box.low = box.low.cwiseMin(corner);
        box.high = box.high.cwiseMax(corner);
        disc = disc.including(corner);
    }
    // The surface deviates by at most this length from a triangle of the corners, and the
    // corners of the triangles lie on the surface.
    const double bulge = bounds.of(cells).chord_error(
        std::ldexp(count_u, -cells.level_u), std::ldexp(count_v, -cells.level_v));
    const double around =
        bulge + rounding_share * std::max(box.low.cwiseAbs().maxCoeff(),
                                          box.high.cwiseAbs().maxCoeff());
    pieces_.push_back(cells);
    discs_.push_back(disc.expanded(around));
    boxes_.front().push_back({box.low.array() - around, box.high.array() + around});
}

void SurfaceTree::add_upper_boxes()
{
    while (boxes_.back().size() > 1) {
        const std::vector<Box>& below = boxes_.back();
        std::vector<Box> above;
        for (std::size_t first = 0; first < below.size(); first += children) {
            Box box = below[first];
            for (std::size_t k = first; k < std::min(first + children, below.size());
                 ++k) {
                box.low = box.low.cwiseMin(below[k].low);
                box.high = box.high.cwiseMax(below[k].high);
            }
            above.push_back(box);
        }
        boxes_.push_back(std::move(above));
    }
}

const SampledPatch& SurfaceTree::sample(std::size_t piece) const
{
    Sample& sample = samples_[piece];
    sample.make_once([&] {
        const Cells& cells = pieces_[piece];
        std::vector<Vec3> points = cells.points();
        sample.patch.emplace(std::move(points), cells.high_u - cells.low_u,
                             cells.high_v - cells.low_v);
    });
    return *sample.patch;
}

void SurfaceTree::look_at(NearestSearch& search, std::size_t piece) const
{
    if (search.may_improve(discs_[piece]))
        sample(piece).look(search, piece);
}

void SurfaceTree::look_into(NearestSearch& search, std::size_t level,
                            std::size_t number) const
{
    if (level == 0) {
        look_at(search, number);
        return;
    }
    const std::vector<Box>& below = boxes_[level - 1];
    std::array<std::pair<double, std::size_t>, children> order;
    std::size_t count = 0;
    for (std::size_t k = number * children;
         k < std::min((number + 1) * children, below.size()); ++k)
        if (const double square = below[k].squared_distance(search.place);
            square * (1 - NearestSearch::square_rounding) <= search.least_square)
            order[count++] = {square, k};
    std::sort(order.begin(), order.begin() + count);
    for (std::size_t k = 0; k < count; ++k)
        if (order[k].first * (1 - NearestSearch::square_rounding) <= search.least_square)
            look_into(search, level - 1, order[k].second);
}

std::optional<NearestPoint> SurfaceTree::nearest(const Vec3& place,
                                                 std::optional<std::size_t> hint,
                                                 double within) const
{
    NearestSearch search{place, within > 0 ? within * within : 0};
    if (hint)
        look_at(search, *hint);
    look_into(search, boxes_.size() - 1, 0);
    if (!search.point)
        return std::nullopt;
    return NearestPoint{*search.point, std::sqrt(search.least_square), search.number};
}

}  // namespace endmill
