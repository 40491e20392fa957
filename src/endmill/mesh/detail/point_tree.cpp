// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/mesh/detail/point_tree.h"

#include <algorithm>
#include <numeric>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// The tree is implicit: the middle of a range is its root, both halves are the subtrees.
std::size_t middle_of(std::size_t begin, std::size_t end)
{
    return begin + (end - begin) / 2;
}

// Ranges of at least this many points have a box. Without boxes, a search would visit all
// points that are equal to one just outside its radius.
constexpr std::size_t least_boxed = 8;

// Number of nodes down to the last level that may have a box: all ranges of a level have
// at most half as many points as those of the level above.
std::size_t boxed_nodes(std::size_t points)
{
    std::size_t nodes = 0;
    for (std::size_t level = 1; points >= least_boxed; level *= 2, points /= 2)
        nodes += level;
    return nodes;
}

}  // namespace

struct PointTree::Search {
    Vec3 place;
    double least_square;  // least squared distance so far, mm^2
    std::optional<std::size_t> nearest;
};

PointTree::Range PointTree::Range::lower_half() const
{
    return {begin, middle_of(begin, end), (axis + 1) % 3, 2 * node + 1};
}

PointTree::Range PointTree::Range::upper_half() const
{
    return {middle_of(begin, end) + 1, end, (axis + 1) % 3, 2 * node + 2};
}

PointTree::PointTree(std::span<const Vec3> points)
    : points_{points},
      order_(points.size()),
      boxes_(boxed_nodes(points.size()))
{
    require(!points.empty() && points.size() < (std::size_t{1} << 31U),
            "PointTree: need between 1 and 2^31 - 1 points");
    std::iota(order_.begin(), order_.end(), 0U);
    build({0, order_.size(), 0, 0});
}

std::optional<std::size_t> PointTree::nearest_within(const Vec3& place,
                                                     double radius) const
{
    Search state{place, radius * radius, std::nullopt};
    search(state, {0, order_.size(), 0, 0});
    return state.nearest;
}

void PointTree::build(const Range& range)
{
    const std::size_t count = range.end - range.begin;
    if (count < 2)
        return;
    const int axis = range.axis;
    const std::span<unsigned> order = std::span{order_}.subspan(range.begin, count);
    if (count >= least_boxed) {
        Box& box = boxes_[range.node] = {points_[order[0]], points_[order[0]]};
        for (const unsigned number : order) {
            box.low = box.low.cwiseMin(points_[number]);
            box.high = box.high.cwiseMax(points_[number]);
        }
    }
    std::ranges::nth_element(
        order,
        order.begin() +
            static_cast<std::ptrdiff_t>(middle_of(range.begin, range.end) - range.begin),
        [&](unsigned a, unsigned b) { return points_[a][axis] < points_[b][axis]; });
    build(range.lower_half());
    build(range.upper_half());
}

// Rounding keeps the order of lengths, so no bound exceeds the computed distance to a
// point beyond it. The half on the side of the place is searched first.
void PointTree::search(Search& state, const Range& range) const
{
    if (range.begin == range.end)
        return;
    if (range.end - range.begin >= least_boxed) {
        const auto& [low, high] = boxes_[range.node];
        const Vec3 offset = (low - state.place).cwiseMax(state.place - high).cwiseMax(0);
        if (offset.squaredNorm() >= state.least_square)
            return;
    }
    const std::size_t middle = middle_of(range.begin, range.end);
    const Vec3& point = points_[order_[middle]];
    const double square = (point - state.place).squaredNorm();
    if (square < state.least_square) {
        state.least_square = square;
        state.nearest = order_[middle];
    }
    const double beyond = state.place[range.axis] - point[range.axis];
    const bool is_below = beyond < 0;
    search(state, is_below ? range.lower_half() : range.upper_half());
    if (beyond * beyond < state.least_square)
        search(state, is_below ? range.upper_half() : range.lower_half());
}

}  // namespace endmill
