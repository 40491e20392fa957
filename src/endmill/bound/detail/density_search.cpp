// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/density_search.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <random>
#include <utility>

#include "endmill/core/parallel.h"

namespace endmill {
namespace {

// Step in the cells in which a random place exceeded 1, as a share of the spacing of nodes.
constexpr double joining_step = 1.0 / 16;

}  // namespace

DensitySearch::DensitySearch(const BoundedPart& part, const BoundProblem& problem,
                             DensitySearchOptions options)
    : part_{part},
      problem_{problem},
      options_{std::move(options)},
      grid_{part_, options_.node_spacing},
      sets_{part_, problem}
{
}

// The places on a lattice in each cell, from its low corner on, about `step` mm apart
// along the surface. Those at the high border of a patch are taken in this patch; the next
// cell has them in its own.
std::vector<ContactPlace> DensitySearch::lattice_places(
    std::span<const DensityCell> cells, double step) const
{
    struct Steps {
        int number;
        int last;
    };
    std::vector<ContactPlace> places;
    for (const DensityCell& cell : cells) {
        const Surface& surface = part_.surfaces[cell.surface];
        const auto steps = [&](Parameter along, int patch, const Interval& range,
                               double length) -> Steps {
            const int number = std::max(1, static_cast<int>(std::lround(length / step)));
            const bool is_border = range.high == surface.breaks(along)[patch + 1];
            return {number, is_border ? number : number - 1};
        };
        const Steps u = steps(Parameter::U, cell.i, cell.u, cell.length_u);
        const Steps v = steps(Parameter::V, cell.j, cell.v, cell.length_v);
        for (int b = 0; b <= v.last; ++b)
            for (int a = 0; a <= u.last; ++a) {
                const SurfacePoint at{
                    std::lerp(cell.u.low, cell.u.high, a / double(u.number)),
                    std::lerp(cell.v.low, cell.v.high, b / double(v.number))};
                places.push_back({cell.surface, cell.i, cell.j, at});
            }
    }
    return places;
}

std::vector<ContactPlace> DensitySearch::random_places(std::size_t count,
                                                       std::uint64_t seed) const
{
    std::vector<double> sums;
    double sum = 0;
    for (const DensityCell& cell : grid_.cells())
        sums.push_back(sum += cell.area);
    std::mt19937_64 engine{seed};
    std::vector<ContactPlace> places;
    for (std::size_t k = 0; k < count; ++k) {
        const double wanted = random_share(engine) * sum;
        const auto found = std::ranges::upper_bound(sums, wanted) - sums.begin();
        const std::size_t number =
            std::min(static_cast<std::size_t>(found), sums.size() - 1);
        const DensityCell& cell = grid_.cells()[number];
        const double u = std::lerp(cell.u.low, cell.u.high, random_share(engine));
        const double v = std::lerp(cell.v.low, cell.v.high, random_share(engine));
        places.push_back({cell.surface, cell.i, cell.j, {u, v}});
    }
    return places;
}

DensitySearch::Tested DensitySearch::tested(const ContactPlace& place,
                                            std::span<const double> density,
                                            CoveredSets::Want want) const
{
    const auto set = sets_.set_at(place, want);
    if (!set)
        return {};
    Tested result;
    result.flows = stored_flows(set->boundary, grid_);
    result.start = 1 / widest_strip(set->frame, problem_);
    if (density.empty())
        return result;
    result.inflow = greatest_inflow(result.flows, grid_, density);
    for (const CoveredPiece& piece : set->pieces)
        result.disc +=
            piece.area * grid_.value(density, grid_.place(piece.surface, piece.at));
    return result;
}

// The first density at a node is that of the nearest place; places run through the cells
// from their lowest node on, so that the first of each cell is the node itself.
void DensitySearch::start_from(const std::vector<ContactPlace>& places)
{
    places_.resize(places.size());
    std::vector<double> start(places.size());
    parallel_for(places.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            Tested result = tested(places[k], {}, CoveredSets::Want::Boundary);
            places_[k] = std::move(result.flows);
            start[k] = result.start;
        }
    });
    density_.assign(grid_.nodes(), 0);
    for (std::size_t k = 0; k < places.size(); ++k) {
        const GridPlace at = grid_.place(places[k].surface, places[k].at);
        const std::size_t corner = (at.u > 0.75F ? 1 : 0) + (at.v > 0.75F ? 2 : 0);
        double& density = density_[grid_.corners(at.node)[corner]];
        density = std::max(density, start[k]);
    }
}

// Adds the places whose inflow exceeds 1; returns their numbers.
std::vector<std::size_t> DensitySearch::test(const std::vector<ContactPlace>& places)
{
    const auto flows_at = [&](std::size_t k) {
        return tested(places[k], {}, CoveredSets::Want::Boundary).flows;
    };
    return join_exceeding(grid_, density_, places.size(), flows_at, places_);
}

// Tests random places, and then the cells of those that exceed 1 more closely.
void DensitySearch::test_at_random(std::uint64_t seed)
{
    const std::vector<ContactPlace> places = random_places(options_.random_places, seed);
    std::vector<std::uint32_t> nodes;
    for (const std::size_t k : test(places))
        nodes.push_back(grid_.place(places[k].surface, places[k].at).node);
    std::ranges::sort(nodes);
    std::vector<DensityCell> cells;
    std::ranges::copy_if(grid_.cells(), std::back_inserter(cells),
                         [&](const DensityCell& cell) {
                             return std::ranges::binary_search(nodes, cell.node);
                         });
    test(lattice_places(cells, options_.node_spacing * joining_step));
}

void DensitySearch::report(double share) const
{
    if (options_.progress)
        options_.progress(share);
}

std::vector<double> DensitySearch::inflows_at_random(std::span<const double> density,
                                                     std::size_t count,
                                                     std::uint64_t seed) const
{
    const std::vector<ContactPlace> places = random_places(count, seed);
    std::vector<double> inflows(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            inflows[k] = tested(places[k], density, CoveredSets::Want::Boundary).inflow;
    });
    return inflows;
}

FoundDensity DensitySearch::run()
{
    report(0);
    start_from(lattice_places(grid_.cells(), options_.node_spacing / 2));
    refine_density(
        grid_, places_, density_,
        {.denser =
             [&] { test(lattice_places(grid_.cells(), options_.node_spacing / 4)); },
         .at_random = [&](std::uint64_t seed) { test_at_random(seed); },
         .report = [&](double share) { report(share); }});
    const std::vector<ContactPlace> last =
        random_places(options_.random_places, last_seed);
    std::vector<double> discs(last.size());
    std::vector<double> inflows(last.size());
    parallel_for(last.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Tested result =
                tested(last[k], density_, CoveredSets::Want::BoundaryAndPieces);
            inflows[k] = result.inflow;
            discs[k] = result.disc;
        }
    });
    FoundDensity found =
        finished_density(grid_, density_, places_.size(), inflows, discs);
    report(1);
    return found;
}

}  // namespace endmill
