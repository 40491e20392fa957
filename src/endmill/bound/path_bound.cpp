// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/path_bound.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/bound/detail/closed_bound.h"
#include "endmill/bound/detail/density_certificate.h"
#include "endmill/bound/detail/density_grid.h"
#include "endmill/bound/detail/density_search.h"
#include "endmill/bound/detail/mesh_density_search.h"
#include "endmill/core/error.h"
#include "endmill/surface/continuity.h"
#include "endmill/surface/extent.h"
#include "endmill/surface/largest_cutter.h"

namespace endmill {
namespace {

// Default spacing of the nodes, as shares of the width of the disc on a plane: the widest, and
// the narrowest, which small parts take.
constexpr double widest_share = 0.7;
constexpr double narrowest_share = 0.35;
// Nodes that a surface has with a spacing between both.
constexpr double usual_nodes = 4000;
// Most nodes, about: at 6 kB each, memory stays below 200 MB.
constexpr double most_nodes = 30000;
constexpr std::size_t least_random_places = 1000;
// Spacing of nodes on meshes as a share of the width of the disc on a plane. The density is
// trilinear between them; on the saddle in 18 432 facets half of it changes the bound by less
// than 0.1 %.
constexpr double mesh_spacing_share = 0.6;
// Most pieces of a mesh that the density is given for.
constexpr std::size_t most_shown_pieces = 20000;
// Share of the estimate in the time of a certificate.
constexpr double estimate_share = 0.15;

void require_valid(std::span<const Surface> surfaces, std::span<const double> sides,
                   const BoundProblem& problem)
{
    require(!surfaces.empty(), "path_bound: need a surface");
    require(surfaces.size() == sides.size(), "path_bound: need a side for each surface");
    require_valid(problem);
}

double surface_spacing(double area, const BoundProblem& problem)
{
    const double width = 2 * plane_half_width(problem);
    return std::clamp(std::sqrt(area / usual_nodes), narrowest_share * width,
                      widest_share * width);
}

// The spacing of the options, or that by default, never so small that there are too many nodes.
double checked_spacing(double area, double by_default, const EstimateOptions& options)
{
    require(options.random_places >= least_random_places,
            "path_bound: need at least 1000 random places");
    const double wanted = options.node_spacing.value_or(by_default);
    require(std::isfinite(wanted) && wanted > 0,
            "path_bound: the spacing of nodes must be positive");
    return std::max(wanted, std::sqrt(area / most_nodes));
}

std::optional<double> positive(double bound)
{
    return bound > 0 ? std::optional{bound} : std::nullopt;
}

PathBound closed_path_bound(const ClosedDensity& closed, double area, int most_pieces)
{
    const double density = area * closed.density_per_mm;
    return {density, closed.disc_mm, positive(density - most_pieces * closed.disc_mm),
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
    const double spacing = checked_spacing(
        area(surfaces), surface_spacing(area(surfaces), problem), options);
    require_smooth(surfaces);
    DensitySearch search{
        {surfaces, sides}, problem, {spacing, options.random_places, options.progress}};
    return {search.run(), spacing};
}

PathBound estimated_from(const FoundDensity& found, double factor,
                         const BoundProblem& problem, double spacing,
                         std::vector<DensityCorners> cells)
{
    const double density = factor * found.integral;
    const double disc = factor * found.greatest_disc;
    return {density,
            disc,
            positive(density - problem.most_pieces * disc),
            BoundGrade::Estimated,
            found.greatest_inflow,
            found.places,
            found.test_places,
            0,
            spacing,
            std::move(cells)};
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

double facing_area(const TriangleMesh& mesh)
{
    double area = 0;
    for (std::size_t k = 0; k < mesh.triangles().size(); ++k) {
        const auto [a, b, c] = mesh.corners(k);
        const Vec3 product = (b - a).cross(c - a);
        if (product.z() > 0)
            area += product.norm() / 2;
    }
    return area;
}

// The pieces of a mesh, as cells whose last corners coincide; nothing if they are many.
std::vector<DensityCorners> cells_of(const MeshDensitySearch& search)
{
    std::vector<DensityCorners> cells;
    if (search.pieces().size() > most_shown_pieces)
        return cells;
    cells.reserve(search.pieces().size());
    for (const FacetPiece& piece : search.pieces()) {
        const auto& [a, b, c] = piece.corners;
        cells.push_back({{a, b, c, c}, search.density_at(piece)});
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
    return estimated_from(found, stray_factor(surfaces, sides, problem), problem, spacing,
                          cells_of(surfaces, sides, spacing, found.at_nodes));
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
            positive(density - problem.most_pieces * disc),
            BoundGrade::Certified,
            proved.greatest_inflow,
            found.places,
            found.test_places,
            proved.boxes,
            spacing,
            cells_of(surfaces, sides, spacing, proved.at_nodes)};
}

PathBound mesh_bound(const TriangleMesh& mesh, const BoundProblem& problem,
                     const EstimateOptions& options)
{
    require_valid(problem);
    require(problem.length == BoundedLength::Tip, "mesh_bound: only tips have a bound");
    const double area = facing_area(mesh);
    if (area == 0)
        throw GeometryError{"no facet of the mesh faces the tool"};
    const double spacing = checked_spacing(
        area, mesh_spacing_share * 2 * plane_half_width(problem), options);
    MeshDensitySearch search{
        mesh, problem, {spacing, options.random_places, options.progress}};
    const FoundDensity found = search.run();
    if (found.greatest_inflow == 0)
        throw GeometryError{
            "the mesh is smaller than what the ball covers at rest, or the ball fits "
            "nowhere "
            "on it"};
    // A centre gamma below its place on an edge moves on a smaller circle.
    const double factor = 1 - problem.stray / problem.cutter.radius();
    return estimated_from(found, factor, problem, search.spacing(), cells_of(search));
}

}  // namespace endmill
