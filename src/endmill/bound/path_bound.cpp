// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/path_bound.h"

#include <algorithm>
#include <cmath>

#include "endmill/bound/detail/closed_bound.h"
#include "endmill/bound/detail/density_certificate.h"
#include "endmill/bound/detail/density_grid.h"
#include "endmill/bound/detail/density_search.h"
#include "endmill/bound/detail/estimate_spacing.h"
#include "endmill/core/error.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {
namespace {

// Share of the estimate in the time of a certificate.
constexpr double estimate_share = 0.15;

void require_valid(std::span<const Surface> surfaces, std::span<const double> sides,
                   const BoundProblem& problem)
{
    require(!surfaces.empty(), "path_bound: need a surface");
    require(surfaces.size() == sides.size(), "path_bound: need a side for each surface");
    require_valid(problem);
}

PathBound closed_path_bound(const ClosedDensity& closed, double area, int most_pieces)
{
    const double density = area * closed.density_per_mm;
    return {density, closed.disc_mm, positive_bound(density, closed.disc_mm, most_pieces),
            BoundGrade::Closed};
}

void require_smooth(std::span<const Surface> surfaces)
{
    const SurfaceContinuity found = continuity(surfaces);
    if (found.continuity != Continuity::G1)
        throw GeometryError{"path_bound: the part is not smooth at " +
                            place_text(found.worst.at, found.worst.point)};
}

// The least ratio of the speeds of a centre that strays and of its place above the
// contact: 1 - gamma max |k / (1 + k R)|.
double stray_factor(std::span<const Surface> surfaces, std::span<const double> sides,
                    const BoundProblem& problem)
{
    if (problem.length == BoundedLength::Contact || problem.stray == 0)
        return 1;
    const auto range = curvature_range(surfaces, sides);
    const double R = problem.cutter.radius();
    double greatest = 0;
    for (const double k : {range ? range->least : 0, range ? range->greatest : 0})
        greatest = std::max(
            greatest, 1 + k * R > 0 ? std::abs(k) / (1 + k * R) : 1 / problem.stray);
    return std::max(0.0, 1 - problem.stray * greatest);
}

// A density found by the search, with its spacing.
struct Estimate {
    FoundDensity found;
    double spacing;
};

Estimate estimate(std::span<const Surface> surfaces, std::span<const double> sides,
                  const BoundProblem& problem, const EstimateOptions& options)
{
    require_valid(surfaces, sides, problem);
    const double spacing = estimate_spacing(
        area(surfaces),
        options.node_spacing.value_or(surface_spacing(area(surfaces), problem)),
        options.random_places);
    require_smooth(surfaces);
    DensitySearch search{
        {surfaces, sides}, problem, {spacing, options.random_places, options.progress}};
    return {search.run(), spacing};
}

// The cells of a density. The grid is that of the search.
std::vector<DensityCorners> cells_of(std::span<const Surface> surfaces,
                                     std::span<const double> sides, double spacing,
                                     std::span<const double> at_nodes)
{
    const DensityGrid grid{{surfaces, sides}, spacing};
    std::vector<DensityCorners> cells;
    cells.reserve(grid.cells().size());
    for (const DensityCell& cell : grid.cells()) {
        const auto point = [&](double u, double v) -> Vec3 {
            return surfaces[cell.surface].tangents(u, v).point;
        };
        double sum = 0;
        for (const std::uint32_t node : grid.corners(cell.node))
            sum += at_nodes[node];
        cells.push_back(
            {{point(cell.u.low, cell.v.low), point(cell.u.high, cell.v.low),
              point(cell.u.high, cell.v.high), point(cell.u.low, cell.v.high)},
             sum / 4});
    }
    return cells;
}

// A progress that shows work as a range of the shares of another.
std::function<void(double)> part_of(const std::function<void(double)>& progress,
                                    double from, double to)
{
    if (!progress)
        return {};
    return [=](double share) { progress(std::lerp(from, to, share)); };
}

}  // namespace

std::string_view bound_grade_name(BoundGrade grade)
{
    switch (grade) {
        case BoundGrade::Closed:
            return "closed";
        case BoundGrade::Certified:
            return "certified";
        case BoundGrade::Estimated:
            break;
    }
    return "estimated";
}

PathBound path_bound(std::span<const Surface> surfaces, std::span<const double> sides,
                     const BoundProblem& problem, const EstimateOptions& options)
{
    require_valid(surfaces, sides, problem);
    if (surfaces.size() == 1)
        if (const auto shape = simple_shape(surfaces.front(), sides.front()))
            if (const auto closed = closed_density(problem, *shape))
                return closed_path_bound(*closed, shape->area, problem.most_pieces);
    return options.grade == BoundGrade::Certified
               ? certified_bound(surfaces, sides, problem, options)
               : estimated_bound(surfaces, sides, problem, options);
}

PathBound estimated_bound(std::span<const Surface> surfaces,
                          std::span<const double> sides, const BoundProblem& problem,
                          const EstimateOptions& options)
{
    const auto [found, spacing] = estimate(surfaces, sides, problem, options);
    const double factor = stray_factor(surfaces, sides, problem);
    const double density = factor * found.integral;
    const double disc = factor * found.greatest_disc;
    return {density,
            disc,
            positive_bound(density, disc, problem.most_pieces),
            BoundGrade::Estimated,
            found.greatest_inflow,
            found.places,
            found.test_places,
            0,
            spacing,
            cells_of(surfaces, sides, spacing, found.at_nodes)};
}

PathBound certified_bound(std::span<const Surface> surfaces,
                          std::span<const double> sides, const BoundProblem& problem,
                          const EstimateOptions& options)
{
    EstimateOptions first = options;
    first.progress = part_of(options.progress, 0, estimate_share);
    const auto [found, spacing] = estimate(surfaces, sides, problem, first);
    CertificateOptions second{spacing};
    second.progress = part_of(options.progress, estimate_share, 1);
    const CertifiedDensity proved =
        certified_density({surfaces, sides}, problem, found.at_nodes, second);
    const double factor = stray_factor(surfaces, sides, problem);
    const double density = factor * proved.integral;
    const double disc = factor * proved.greatest_disc;
    return {density,
            disc,
            positive_bound(density, disc, problem.most_pieces),
            BoundGrade::Certified,
            proved.greatest_inflow,
            found.places,
            found.test_places,
            proved.boxes,
            spacing,
            cells_of(surfaces, sides, spacing, proved.at_nodes)};
}

}  // namespace endmill
