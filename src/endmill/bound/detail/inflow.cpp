// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/inflow.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace endmill {
namespace {

// A number that rises with the angle of (x, y) from -pi to pi.
float angle_order(const StoredFlow& flow)
{
    const float share = flow.x / (std::abs(flow.x) + std::abs(flow.y));
    return std::copysign(1 - share, flow.y);
}

}  // namespace

std::vector<StoredFlow> stored_flows(std::span<const BoundaryFlow> boundary,
                                     const DensityGrid& grid)
{
    std::vector<StoredFlow> flows;
    flows.reserve(boundary.size());
    for (const BoundaryFlow& piece : boundary) {
        const auto x = static_cast<float>(piece.flow.x());
        const auto y = static_cast<float>(piece.flow.y());
        if (x != 0 || y != 0)  // a flow of zero has no angle
            flows.push_back({grid.place(piece.surface, piece.at), x, y});
    }
    std::ranges::sort(flows, {}, [](const StoredFlow& flow) {
        return std::pair{angle_order(flow), std::pair{flow.x, flow.place.node}};
    });
    return flows;
}

double greatest_inflow(std::span<const StoredFlow> flows, const DensityGrid& grid,
                       std::span<const double> density)
{
    const std::size_t count = flows.size();
    std::vector<Eigen::Vector2d> part(count);
    for (std::size_t k = 0; k < count; ++k)
        part[k] =
            grid.value(density, flows[k].place) * Eigen::Vector2d{flows[k].x, flows[k].y};
    // The sum over the flows from `first` that are less than half a turn ahead of it.
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    std::size_t end = 0;
    double greatest = 0;
    for (std::size_t first = 0; first < count; ++first) {
        if (end == first)
            sum = part[end++];
        const StoredFlow& from = flows[first];
        while (end < first + count) {
            const std::size_t k = end < count ? end : end - count;
            const double turn = double{from.x} * flows[k].y - double{from.y} * flows[k].x;
            const double along =
                double{from.x} * flows[k].x + double{from.y} * flows[k].y;
            if (turn < 0 || (turn == 0 && along < 0))
                break;
            sum += part[k];
            ++end;
        }
        greatest = std::max(greatest, sum.squaredNorm());
        sum -= part[first];
    }
    return std::sqrt(greatest);
}

}  // namespace endmill
