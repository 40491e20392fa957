// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <tuple>
#include <vector>

#include <Eigen/Core>

#include "endmill/bound/detail/cover_boundary.h"
#include "endmill/bound/detail/density_grid.h"

namespace endmill {

/// A piece of the boundary of D(x) as the search for a density stores it.
/// \tparam Place of the density: GridPlace or LatticePlace.
template <typename Place>
struct FlowAt {
    Place place;  ///< where the density is taken
    float x;      ///< component of the flow along e1, mm
    float y;      ///< component along e2, mm
};

/// A piece of the boundary on a grid over surfaces.
using StoredFlow = FlowAt<GridPlace>;

/// The pieces in the order of the angles of their flows.
std::vector<StoredFlow> stored_flows(std::span<const BoundaryFlow> boundary,
                                     const DensityGrid& grid);

/// Sorts flows by their angles from -pi to pi. None is zero.
template <typename Place>
void sort_by_angle(std::vector<FlowAt<Place>>& flows)
{
    std::ranges::sort(flows, {}, [](const FlowAt<Place>& flow) {
        const float share = flow.x / (std::abs(flow.x) + std::abs(flow.y));
        return std::tuple{std::copysign(1 - share, flow.y), flow.x, flow.place.node};
    });
}

/// The greatest inflow over all directions t of travel: the maximum of
/// sum g max(0, flow . t). It is the length of the longest sum of flows within half a
/// turn, which n sums give exactly.
/// \param flows in the order of `sort_by_angle`.
/// \param grid of the density: DensityGrid or DensityLattice.
/// \param density g at the nodes, 1/mm.
/// \return at most 1 if the density keeps the condition of the bound here.
template <typename Place, typename Grid>
double greatest_inflow(const std::vector<FlowAt<Place>>& flows, const Grid& grid,
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
        const FlowAt<Place>& from = flows[first];
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
