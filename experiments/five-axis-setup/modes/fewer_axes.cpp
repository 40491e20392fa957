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

// Decides whether a number of directions reaches every facet that any cell reaches. One
// of the directions must reach the facet with the smallest cone, so only its cells are
// tried first; then the same for the facets left.
class DirectionCover {
public:
    explicit DirectionCover(const VisibilityMap& map)
        : map_{&map},
          reachable_(map.words(), 0),
          cones_(map.facets())
    {
        for (std::size_t cell = 0; cell < map.cells(); ++cell)
            for (std::size_t word = 0; word < map.words(); ++word)
                reachable_[word] |= map.column(cell)[word];
        for (std::size_t facet = 0; facet < map.facets(); ++facet)
            for (std::size_t cell = 0; cell < map.cells(); ++cell)
                if (map.is_accessible(facet, cell))
                    cones_[facet].push_back(cell);
    }

    bool suffices(int directions) const { return suffices(reachable_, directions); }

private:
    using Facets = std::vector<std::uint64_t>;

    bool suffices(const Facets& left, int directions) const
    {
        const std::vector<std::size_t>* smallest = nullptr;
        for (std::size_t facet = 0; facet < cones_.size(); ++facet)
            if ((left[facet / 64] >> (facet % 64) & 1) != 0 &&
                (smallest == nullptr || cones_[facet].size() < smallest->size()))
                smallest = &cones_[facet];
        if (smallest == nullptr)
            return true;
        return directions > 0 && std::ranges::any_of(*smallest, [&](std::size_t cell) {
                   Facets rest = left;
                   for (std::size_t word = 0; word < rest.size(); ++word)
                       rest[word] &= ~map_->column(cell)[word];
                   return suffices(rest, directions - 1);
               });
    }

    const VisibilityMap* map_;
    Facets reachable_;
    std::vector<std::vector<std::size_t>> cones_;
};

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

NamedCells three_axes_cells(const StudiedPart& part, int most_setups)
{
    const VisibilityMap& map = part.visibility.map;
    NamedCells cells = reach_cells(part, {widest_direction(map).cell});
    const DirectionCover cover{map};
    for (int setups = 1; setups <= most_setups; ++setups)
        if (cover.suffices(setups)) {
            cells.emplace_back("setups", std::int64_t{setups});
            break;
        }
    return cells;
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
