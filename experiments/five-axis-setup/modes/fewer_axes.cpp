// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/modes/fewer_axes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <Eigen/Geometry>

#include "endmill/setup/detail/arc_search.h"

namespace endmill {
namespace {

// Sine of the largest distance of a centre from its circle of symmetry, by rounding.
constexpr double on_circle = 1e-9;

CsvCell count(std::size_t number)
{
    return static_cast<std::int64_t>(number);
}

CsvCell degrees(double angle)
{
    return Angle::radians(angle).degrees();
}

std::size_t facets_left(const VisibilityMap& map, const std::vector<std::size_t>& cells)
{
    std::size_t left = 0;
    for (std::size_t facet = 0; facet < map.facets(); ++facet) {
        const auto reaches = [&](std::size_t cell) {
            return map.is_accessible(facet, cell);
        };
        left += std::ranges::none_of(cells, reaches) ? 1 : 0;
    }
    return left;
}

}  // namespace

std::vector<std::size_t> cells_on_circle(const SphereGrid& grid, const Vec3& axis,
                                         const Vec3& middle, Angle reach)
{
    std::vector<std::size_t> cells;
    for (std::size_t k = 0; k < grid.centres.size(); ++k) {
        const Vec3& centre = grid.centres[k];
        const double angle = std::atan2(centre.cross(middle).norm(), centre.dot(middle));
        if (std::abs(centre.dot(axis)) < on_circle && angle <= reach.radians())
            cells.push_back(k);
    }
    return cells;
}

NamedCells reach_cells(const StudiedPart& part, const std::vector<std::size_t>& cells)
{
    return {{"cells", count(cells.size())},
            {"facets_left", count(facets_left(part.visibility.map, cells))}};
}

NamedCells three_axes_cells(const StudiedPart& part)
{
    return reach_cells(part, {widest_direction(part.visibility.map).cell});
}

NamedCells four_axes_cells(const StudiedPart& part, const Vec3& axis)
{
    const auto arc =
        shortest_arc(part.visibility.map, part.grid.centres, axis, Angle::degrees(0));
    return {{"arc_deg", arc ? degrees(arc->length) : CsvCell{}}};
}

NamedCells best_four_axes_cells(const StudiedPart& part, const SphereGrid& axes,
                                Angle tolerance)
{
    const PoseSearchResult found =
        arc_search(part.visibility.map, part.grid.centres, axes.centres, {}, tolerance);
    if (!found.least)
        return {};
    return {{"arc_deg", degrees(found.least->phi.to - found.least->phi.from)}};
}

}  // namespace endmill
