// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/savings/tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/angle.h"
#include "endmill/mesh/triangle_tree.h"
#include "endmill/setup/detail/arc_search.h"
#include "endmill/setup/pose_search.h"
#include "endmill/visibility/nearest_cells.h"
#include "support/setup_cells.h"

namespace endmill {
namespace {

// The cosine that a facet's normal must exceed even at an incidence of 90 degrees: the spec's.
constexpr double least_cosine = 1e-6;

double extent(const TriangleMesh& mesh)
{
    double largest = 0;
    for (const Vec3& point : mesh.points())
        largest = std::max(largest, point.norm());
    return largest;
}

std::size_t accessible_entries(const VisibilityMap& map)
{
    std::size_t entries = 0;
    for (std::size_t cell = 0; cell < map.cells(); ++cell)
        for (const std::uint64_t word : map.column(cell))
            entries += static_cast<std::size_t>(std::popcount(word));
    return entries;
}

CsvCell count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

}  // namespace

SetupSavings setup_savings(const StudiedPart& part)
{
    const auto cells = static_cast<double>(part.visibility.map.cells());
    const auto facets = static_cast<double>(part.visibility.map.facets());
    const double group_1 =
        static_cast<double>(accessible_entries(part.visibility.map)) / cells;
    double nearest = 0;
    for (std::size_t cell = 0; cell < part.visibility.map.cells(); ++cell)
        nearest += static_cast<double>(
            nearest_cells(part.visibility.map, part.grid.centres, cell).size());
    return {100 * group_1 / facets, facets - group_1, nearest / cells};
}

NamedCells cone_cells(const StudiedPart& part)
{
    return {{"facets", count(part.visibility.map.facets())},
            {"empty_cones", count(empty_cones(part.visibility).size())},
            {"accessible_entries", count(accessible_entries(part.visibility.map))}};
}

NamedCells saving_cells(const StudiedPart& part)
{
    const SetupSavings savings = setup_savings(part);
    const PoseSearchResult search =
        pose_search(part.visibility.map, part.grid.centres, {});
    return {
        {"group_1_percent", savings.group_1_percent},
        {"group_2_mean", savings.group_2_mean},
        {"nearest_cells_mean", savings.nearest_cells_mean},
        {"left_by_best_direction", count(part.visibility.map.facets() -
                                         widest_direction(part.visibility.map).facets)},
        {"ca_paper_area_deg2", square_degrees(search.least.value().area)}};
}

StudiedPart offset_start_part(TriangleMesh mesh, const std::string& grid, Angle incidence,
                              double start)
{
    StudiedPart part{std::move(mesh), sphere_grid(grid), {}};
    const TriangleTree tree{part.mesh};
    const double offset = start * extent(part.mesh);
    const double cosine = std::max(std::cos(incidence.radians()), least_cosine);
    const std::size_t facets = part.mesh.triangles().size();
    part.visibility.map = {facets, part.grid.centres.size()};
    for (std::size_t j = 0; j < facets; ++j) {
        const auto [a, b, c] = part.mesh.corners(j);
        const Vec3 normal = (b - a).cross(c - a).normalized();
        const Vec3 origin = (a + b + c) / 3 + offset * normal;
        for (std::size_t cell = 0; cell < part.grid.centres.size(); ++cell) {
            const Vec3& direction = part.grid.centres[cell];
            if (normal.dot(direction) > cosine && !tree.any_hit({origin, direction}))
                part.visibility.map.column(cell)[j / 64] |= std::uint64_t{1} << (j % 64);
        }
    }
    return part;
}

}  // namespace endmill
