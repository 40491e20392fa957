// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/point_tree.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "endmill/core/error.h"

namespace endmill {

struct PointTree::Search {
    Vec3 place;
    double least_square;  // of the distances so far, mm^2
    unsigned nearest;
};

PointTree::PointTree(std::span<const Vec3> points)
    : points_{points},
      order_(points.size())
{
    require(!points.empty() && points.size() < (std::size_t{1} << 31U),
            "PointTree: need between 1 and 2^31 - 1 points");
    std::iota(order_.begin(), order_.end(), 0U);
    build(0, order_.size(), 0);
}

std::size_t PointTree::nearest(const Vec3& place) const
{
    Search state{place, std::numeric_limits<double>::infinity(), order_.front()};
    search(state, 0, order_.size(), 0);
    return state.nearest;
}

void PointTree::build(std::size_t begin, std::size_t end, int depth)
{
    if (end - begin < 2)
        return;
    const std::size_t middle = begin + (end - begin) / 2;
    const int axis = depth % 3;
    const std::span<unsigned> range = std::span{order_}.subspan(begin, end - begin);
    std::ranges::nth_element(
        range, range.begin() + static_cast<std::ptrdiff_t>(middle - begin),
        [&](unsigned a, unsigned b) { return points_[a][axis] < points_[b][axis]; });
    build(begin, middle, depth + 1);
    build(middle + 1, end, depth + 1);
}

void PointTree::search(Search& state, std::size_t begin, std::size_t end, int depth) const
{
    if (begin == end)
        return;
    const std::size_t middle = begin + (end - begin) / 2;
    const Vec3& point = points_[order_[middle]];
    const double square = (point - state.place).squaredNorm();
    if (square < state.least_square) {
        state.least_square = square;
        state.nearest = order_[middle];
    }
    const double beyond = state.place[depth % 3] - point[depth % 3];
    const bool low_first = beyond < 0;
    const auto side = [&](bool low) {
        low ? search(state, begin, middle, depth + 1)
            : search(state, middle + 1, end, depth + 1);
    };
    side(low_first);
    if (beyond * beyond < state.least_square)
        side(!low_first);
}

}  // namespace endmill
