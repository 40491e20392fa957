// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/deviation/detail/sampled_patch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/mesh/triangle_tree.h"

// The tree halves the grid of cells across its longer side down to leaves of 2 by 2
// cells. Smaller leaves would take longer to make than they save, because few queries
// come as near as a leaf. Node k of a range with n leaves has its lower half at k + 1 and
// its upper half at k + n, because a binary tree over n/2 leaves has n - 1 nodes. A query
// descends into the nearer half first, and skips a half whose disc is further away than
// the best place.

namespace endmill {
namespace {

// Margin of the discs as a share of the largest coordinate; exceeds the rounding errors.
constexpr double margin_share = 1e-12;
// Greatest number of cells along a side of a leaf.
constexpr int most_leaf_cells = 2;

bool is_power_of_two(int count)
{
    return count > 0 && std::has_single_bit(static_cast<unsigned>(count));
}

}  // namespace

SampledPatch::SampledPatch(std::vector<Vec3> points, int columns, int rows)
    : points_{std::move(points)},
      columns_{columns},
      rows_{rows}
{
    require(is_power_of_two(columns) && is_power_of_two(rows),
            "SampledPatch: need powers of two of cells");
    require(points_.size() == static_cast<std::size_t>(columns + 1) *
                                  static_cast<std::size_t>(rows + 1),
            "SampledPatch: need a point for each corner");
    for (const Vec3& at : points_)
        margin_ = std::max(margin_, margin_share * at.lpNorm<Eigen::Infinity>());
    const Range whole{0, 0, columns, rows};
    discs_.reserve(2 * whole.leaves() - 1);
    add(whole);
}

const Vec3& SampledPatch::point(int u, int v) const
{
    return points_[static_cast<std::size_t>(v) *
                       (static_cast<std::size_t>(columns_) + 1) +
                   static_cast<std::size_t>(u)];
}

bool SampledPatch::Range::is_leaf() const
{
    return std::max(high_u - low_u, high_v - low_v) <= most_leaf_cells;
}

std::size_t SampledPatch::Range::leaves() const
{
    const int columns = std::max(1, (high_u - low_u) / most_leaf_cells);
    const int rows = std::max(1, (high_v - low_v) / most_leaf_cells);
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
}

std::array<SampledPatch::Range, 2> SampledPatch::Range::halves() const
{
    Range low = *this;
    Range high = *this;
    if (high_u - low_u >= high_v - low_v)
        low.high_u = high.low_u = (low_u + high_u) / 2;
    else
        low.high_v = high.low_v = (low_v + high_v) / 2;
    return {low, high};
}

TangentDisc SampledPatch::around(const Range& range) const
{
    const std::array<Vec3, 4> corners{
        point(range.low_u, range.low_v), point(range.high_u, range.low_v),
        point(range.high_u, range.high_v), point(range.low_u, range.high_v)};
    TangentDisc disc = tangent_disc(corners);
    double lowest = 0;
    double highest = 0;
    double furthest = 0;  // squared distance from the centre
    for (int v = range.low_v; v <= range.high_v; ++v)
        for (int u = range.low_u; u <= range.high_u; ++u) {
            const Vec3 away = point(u, v) - disc.centre;
            const double over = away.dot(disc.normal);
            lowest = std::min(lowest, over);
            highest = std::max(highest, over);
            furthest = std::max(furthest, away.squaredNorm());
        }
    disc.centre += (lowest + highest) / 2 * disc.normal;
    disc.half_thickness = (highest - lowest) / 2;
    disc.radius = std::sqrt(furthest);  // an upper bound of the distance along the plane
    return disc.expanded(margin_);
}

void SampledPatch::add(const Range& range)
{
    discs_.push_back(around(range));
    if (!range.is_leaf())
        for (const Range& half : range.halves())
            add(half);
}

void SampledPatch::look(NearestSearch& search, std::size_t number) const
{
    if (search.may_improve(discs_.front()))
        look_into(search, number, {0, 0, columns_, rows_}, 0);
}

// Visits the nearer half first, so that the other half may be skipped.
void SampledPatch::look_into(NearestSearch& search, std::size_t number,
                             const Range& range, std::size_t node) const
{
    if (range.is_leaf()) {
        look_at_cells(search, number, range);
        return;
    }
    const std::array<Range, 2> halves = range.halves();
    const std::array<std::size_t, 2> nodes{node + 1, node + range.leaves()};
    const std::array<double, 2> squares{discs_[nodes[0]].squared_distance(search.place) *
                                            (1 - NearestSearch::square_rounding),
                                        discs_[nodes[1]].squared_distance(search.place) *
                                            (1 - NearestSearch::square_rounding)};
    const std::size_t first = squares[0] <= squares[1] ? 0 : 1;
    for (const std::size_t half : {first, 1 - first})
        if (squares[half] <= search.least_square)
            look_into(search, number, halves[half], nodes[half]);
}

void SampledPatch::look_at_cells(NearestSearch& search, std::size_t number,
                                 const Range& range) const
{
    for (int v = range.low_v; v < range.high_v; ++v)
        for (int u = range.low_u; u < range.high_u; ++u) {
            const auto triangle = 2 * static_cast<std::size_t>(v * columns_ + u);
            const Vec3& a = point(u, v);
            const Vec3& b = point(u + 1, v);
            const Vec3& c = point(u + 1, v + 1);
            const Vec3& d = point(u, v + 1);
            search.take(nearest_on_triangle(search.place, {a, b, c}), number, triangle);
            search.take(nearest_on_triangle(search.place, {a, c, d}), number,
                        triangle + 1);
        }
}

}  // namespace endmill
