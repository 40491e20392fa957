// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "endmill/bound/detail/inflow.h"
#include "endmill/core/parallel.h"

namespace endmill {

/// One multiplicative update of a density: g at a node changes by m^(-1/2) if m > 1 and else
/// by m^(-1/4), where m is the greatest inflow of all places whose boundary meets a cell about
/// the node. Where no boundary comes, g becomes 0.
/// \tparam Grid DensityGrid or DensityLattice.
/// \param grid    of the density.
/// \param places  the flows of each place, from `sort_by_angle`.
/// \param density g at the nodes, 1/mm.
/// \return the greatest inflow before the update.
template <typename Grid, typename Place>
double update_density(const Grid& grid,
                      const std::vector<std::vector<FlowAt<Place>>>& places,
                      std::vector<double>& density)
{
    std::vector<double> inflow(places.size());
    parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            inflow[k] = greatest_inflow(places[k], grid, density);
    });
    std::vector<double> of_cell(grid.nodes());  // by the lowest node of the cell
    for (std::size_t k = 0; k < places.size(); ++k)
        for (const FlowAt<Place>& flow : places[k]) {
            double& greatest = of_cell[flow.place.node];
            greatest = std::max(greatest, inflow[k]);
        }
    std::vector<double> of_node(grid.nodes());
    for (const auto& cell : grid.cells())
        for (const std::uint32_t corner : grid.corners(cell.node))
            of_node[corner] = std::max(of_node[corner], of_cell[cell.node]);
    for (std::size_t node = 0; node < grid.nodes(); ++node) {
        const double m = of_node[node];
        density[node] *= m == 0  ? 0
                         : m > 1 ? 1 / std::sqrt(m)
                                 : 1 / std::sqrt(std::sqrt(m));
    }
    return inflow.empty() ? 0 : *std::ranges::max_element(inflow);
}

/// Updates a density several times. Keeps the one with the greatest integral per greatest
/// inflow, divided by the latter.
/// Source: docs/methods/path-length-bound.md, section 6.
template <typename Grid, typename Place>
void improve_density(const Grid& grid,
                     const std::vector<std::vector<FlowAt<Place>>>& places,
                     std::vector<double>& density, int updates)
{
    std::vector<double> best = density;
    double best_integral = 0;
    for (int k = 0; k < updates; ++k) {
        const std::vector<double> before = density;
        const double greatest = update_density(grid, places, density);
        if (greatest == 0)
            break;
        const double integral = std::inner_product(before.begin(), before.end(),
                                                   grid.weights().begin(), 0.0) /
                                greatest;
        if (integral <= best_integral)
            continue;
        best_integral = integral;
        best = before;
        for (double& at_node : best)
            at_node /= greatest;
    }
    density = std::move(best);
}

}  // namespace endmill
