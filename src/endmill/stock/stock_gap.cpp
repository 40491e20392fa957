// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/stock/stock_gap.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Of a point outside an interval; 0 inside.
double beyond(double at, double low, double high)
{
    return std::max({low - at, at - high, 0.0});
}

// From the block to the axis of the cutter above the ball's centre.
double axis_distance(const Vec3& centre, const Block& block)
{
    return std::hypot(beyond(centre.x(), block.low.x(), block.high.x()),
                      beyond(centre.y(), block.low.y(), block.high.y()),
                      std::max(centre.z() - block.high.z(), 0.0));
}

// Along a move the distance is convex: thirds close in on its least value.
double least_axis_distance(const Vec3& from, const Vec3& to, const Block& block)
{
    constexpr int steps = 40;  // (2/3)^40 is 1e-7
    double low = 0;
    double high = 1;
    const auto at = [&](double share) {
        return axis_distance(from + share * (to - from), block);
    };
    for (int k = 0; k < steps; ++k) {
        const double left = low + (high - low) / 3;
        const double right = high - (high - low) / 3;
        if (at(left) <= at(right))
            high = right;
        else
            low = left;
    }
    return std::min({at(0), at((low + high) / 2), at(1)});
}

}  // namespace

double stock_gap(const ToolPath& path, std::span<const std::size_t> points,
                 const Cutter& cutter, const Block& block)
{
    require(cutter.is_ball(), "stock_gap: need a ball-end mill");
    double least = std::numeric_limits<double>::infinity();
    for (const std::size_t point : points) {
        require(point > 0 && point < path.points.size(),
                "stock_gap: need points of the path after its first");
        const Vec3 up = cutter.radius() * Vec3::UnitZ();
        least = std::min(
            least, least_axis_distance(path.points[point - 1].location.tip + up,
                                       path.points[point].location.tip + up, block));
    }
    return std::max(least - cutter.radius(), 0.0);
}

}  // namespace endmill
