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

}  // namespace

struct PointTree::Search {
    Vec3 place;
    double least_square;  // least squared distance so far, mm^2
    std::optional<std::size_t> nearest;
};

PointTree::PointTree(std::span<const Vec3> points)
    : points_{points},
      order_(points.size())
{
    require(!points.empty() && points.size() < (std::size_t{1} << 31U),
            "PointTree: need between 1 and 2^31 - 1 points");
    low_ = high_ = points.front();
    for (const Vec3& point : points) {
        low_ = low_.cwiseMin(point);
        high_ = high_.cwiseMax(point);
    }
    std::iota(order_.begin(), order_.end(), 0U);
    build({0, order_.size(), 0});
}

std::optional<std::size_t> PointTree::nearest_within(const Vec3& place,
                                                     double radius) const
{
    Search state{place, radius * radius, std::nullopt};
    const Vec3 offset = (low_ - place).cwiseMax(place - high_).cwiseMax(0);
    search(state, {0, order_.size(), 0}, offset);
    return state.nearest;
}

void PointTree::build(const Range& range)
{
    if (range.end - range.begin < 2)
        return;
    const std::size_t middle = middle_of(range.begin, range.end);
    const int axis = range.axis;
    const std::span<unsigned> order =
        std::span{order_}.subspan(range.begin, range.end - range.begin);
    std::ranges::nth_element(
        order, order.begin() + static_cast<std::ptrdiff_t>(middle - range.begin),
        [&](unsigned a, unsigned b) { return points_[a][axis] < points_[b][axis]; });
    build({range.begin, middle, (axis + 1) % 3});
    build({middle + 1, range.end, (axis + 1) % 3});
}

// `offset` is the distance along each axis from the place to the box of the range. Its
// length is a lower bound on the distance to every point of the range.
void PointTree::search(Search& state, const Range& range, const Vec3& offset) const
{
    if (range.begin == range.end || offset.squaredNorm() >= state.least_square)
        return;
    const std::size_t middle = middle_of(range.begin, range.end);
    const Vec3& point = points_[order_[middle]];
    const double square = (point - state.place).squaredNorm();
    if (square < state.least_square) {
        state.least_square = square;
        state.nearest = order_[middle];
    }
    const int axis = range.axis;
    const double beyond = state.place[axis] - point[axis];
    Vec3 far_offset = offset;
    far_offset[axis] = std::max(offset[axis], std::abs(beyond));
    const Range low{range.begin, middle, (axis + 1) % 3};
    const Range high{middle + 1, range.end, (axis + 1) % 3};
    search(state, beyond < 0 ? low : high, offset);
    search(state, beyond < 0 ? high : low, far_offset);
}

}  // namespace endmill
