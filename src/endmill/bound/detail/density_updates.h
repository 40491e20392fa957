// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <numeric>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "endmill/bound/detail/inflow.h"
#include "endmill/core/parallel.h"

/// \file
/// The search for a density, as far as it is the same on surfaces and on meshes.
/// Source: docs/methods/path-length-bound.md, section 6.

namespace endmill {

/// How a density is searched for.
struct DensitySearchOptions {
    double node_spacing;                              ///< mm, along the part
    std::size_t random_places;                        ///< places of the last test
    std::function<void(double share)> progress = {};  ///< called with 0 to 1
};

/// A density whose inflow is at most 1 at every tested place, and its integrals.
struct FoundDensity {
    std::vector<double> at_nodes;  ///< g, 1/mm
    double integral = 0;           ///< of g over the part, mm
    double greatest_disc = 0;      ///< greatest integral of g over a covered set, mm
    /// Greatest inflow at the random places of the last test, before all were divided by
    /// the greatest inflow of all places.
    double greatest_inflow = 0;
    std::size_t places = 0;       ///< places at which the inflow was limited
    std::size_t test_places = 0;  ///< random places of the last test
};

/// Seed of the random places of the last test.
inline constexpr std::uint64_t last_seed = 1;

/// A random number from 0 to below 1, the same on every machine.
inline double random_share(std::mt19937_64& engine)
{
    return std::ldexp(static_cast<double>(engine() >> 11U), -53);
}

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

/// Adds the flows of those of `count` places whose inflow exceeds 1. The flows of others are
/// given up in batches, so that memory does not grow with the number of places.
/// \param flows_at the flows of a place by its number; empty where the ball cannot touch.
/// \return the numbers of the places that were added.
template <typename Grid, typename Place, typename FlowsAt>
std::vector<std::size_t> join_exceeding(const Grid& grid, std::span<const double> density,
                                        std::size_t count, const FlowsAt& flows_at,
                                        std::vector<std::vector<FlowAt<Place>>>& places)
{
    constexpr std::size_t batch = 4096;
    constexpr double accepted_excess = 5e-4;
    std::vector<std::size_t> exceeding;
    for (std::size_t first = 0; first < count; first += batch) {
        std::vector<std::vector<FlowAt<Place>>> flows(std::min(batch, count - first));
        parallel_for(flows.size(), [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                flows[k] = flows_at(first + k);
                if (!(greatest_inflow(flows[k], grid, density) > 1 + accepted_excess))
                    flows[k] = {};
            }
        });
        for (std::size_t k = 0; k < flows.size(); ++k)
            if (!flows[k].empty()) {
                places.push_back(std::move(flows[k]));
                exceeding.push_back(first + k);
            }
    }
    return exceeding;
}

/// How a search finds further places, and what it reports.
struct DensityTests {
    std::function<void()> denser;  ///< adds places of a denser lattice that exceed 1
    /// Adds the random places of a seed that exceed 1, and places beside them.
    std::function<void(std::uint64_t seed)> at_random;
    std::function<void(double share)>
        report;  ///< takes the share of the work that is done
};

/// The updates and tests of a search, from the first density and its places on.
template <typename Grid, typename Place>
void refine_density(const Grid& grid, std::vector<std::vector<FlowAt<Place>>>& places,
                    std::vector<double>& density, const DensityTests& tests)
{
    constexpr int first_updates = 40;
    constexpr int second_updates = 20;
    constexpr int later_updates = 12;
    constexpr int joining_tests = 3;
    tests.report(0.1);
    improve_density(grid, places, density, first_updates);
    tests.report(0.2);
    tests.denser();
    improve_density(grid, places, density, second_updates);
    for (int k = 0; k < joining_tests; ++k) {
        tests.report(0.5 + 0.1 * k);
        tests.at_random(last_seed + 1 + k);
        improve_density(grid, places, density, later_updates);
    }
    tests.report(0.8);
}

/// Divides a density by the greatest inflow of the last test, if that exceeds 1.
/// \param places number of the places of the search.
/// \param inflows, discs of the last test, for the density before the division.
template <typename Grid>
FoundDensity finished_density(const Grid& grid, std::vector<double>& density,
                              std::size_t places, std::span<const double> inflows,
                              std::span<const double> discs)
{
    FoundDensity found;
    found.places = places;
    found.test_places = inflows.size();
    if (!inflows.empty()) {
        found.greatest_inflow = *std::ranges::max_element(inflows);
        found.greatest_disc = *std::ranges::max_element(discs);
    }
    const double divisor = std::max(1.0, found.greatest_inflow);
    found.greatest_disc /= divisor;
    for (double& at_node : density)
        at_node /= divisor;
    found.at_nodes = density;
    found.integral =
        std::inner_product(density.begin(), density.end(), grid.weights().begin(), 0.0);
    return found;
}

}  // namespace endmill
