// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/orientation/setup_regions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

// How small regions join their neighbours.
//
// 1. Facets of one direction that share an edge are one region. A graph holds for each region
//    its area, its facets and the length of its border with each neighbour.
// 2. The smallest region below the limit that has a neighbour whose direction sees all its
//    facets takes that direction. All neighbours of this direction become one region with it.
// 3. Step 2 is repeated with the regions that changed. Every step makes one region of at least
//    two, so that the number of steps is below the number of regions.

namespace endmill {
namespace {

// Products n . v within this count as equal: far above the rounding of normals of coplanar
// facets, far below what changes a cut.
constexpr double equal_products = 1e-9;

Vec3 area_vector(const TriangleMesh& part, std::size_t facet)
{
    const auto [a, b, c] = part.corners(facet);
    return (b - a).cross(c - a) / 2;
}

// The direction of the largest n . v for which `is_possible` holds.
template <typename IsPossible>
std::optional<std::size_t> best_direction(const Vec3& normal,
                                          std::span<const Vec3> directions,
                                          const IsPossible& is_possible)
{
    std::optional<std::size_t> best;
    double most = 0;
    for (std::size_t k = 0; k < directions.size(); ++k) {
        if (!is_possible(k))
            continue;
        const double product = normal.dot(directions[k]);
        if (!best || product > most + equal_products) {
            best = k;
            most = product;
        }
    }
    return best;
}

// A connected set of facets of one direction.
struct Region {
    std::size_t direction = 0;
    double area = 0;                             // mm^2
    std::vector<std::size_t> facets = {};        // empty once it has joined another one
    std::map<std::size_t, double> borders = {};  // length in mm by region
};

// The regions of a part, while small ones join their neighbours.
class RegionGraph {
public:
    RegionGraph(const TriangleMesh& part, const VisibilityMap& map,
                std::vector<std::optional<std::size_t>>& direction_of)
        : part_{part},
          map_{map},
          direction_of_{direction_of}
    {
        collect_edges();
        collect_regions();
    }

    // Joins regions below an area in mm^2.
    // \return the number of regions that joined a neighbour.
    std::size_t join_below(double area)
    {
        std::set<std::pair<double, std::size_t>> small;
        const auto note = [&](std::size_t region) {
            if (!regions_[region].facets.empty() && regions_[region].area < area)
                small.emplace(regions_[region].area, region);
        };
        for (std::size_t region = 0; region < regions_.size(); ++region)
            note(region);
        std::size_t joined = 0;
        while (!small.empty()) {
            const std::size_t region = small.begin()->second;
            small.erase(small.begin());
            const std::optional<std::size_t> direction = other_direction(region);
            if (!direction)
                continue;
            ++joined;
            regions_[region].direction = *direction;
            for (const std::size_t other : neighbours_along(region, *direction)) {
                small.erase({regions_[other].area, other});
                absorb(region, other);
            }
            note(region);
            // a neighbour may now see one of its own neighbours from another direction
            for (const auto& [other, length] : regions_[region].borders)
                note(other);
        }
        for (const Region& region : regions_)
            for (const std::size_t facet : region.facets)
                direction_of_[facet] = region.direction;
        return joined;
    }

private:
    // An edge between two facets.
    struct SharedEdge {
        std::array<std::size_t, 2> facets;
        double length;  // mm
    };

    void collect_edges()
    {
        std::vector<std::pair<MeshEdge, std::size_t>> uses;
        uses.reserve(3 * direction_of_.size());
        for (std::size_t facet = 0; facet < direction_of_.size(); ++facet) {
            const Triangle& corners = part_.triangles()[facet];
            for (std::size_t k = 0; direction_of_[facet] && k < 3; ++k) {
                const auto [low, high] = std::minmax(corners[k], corners[(k + 1) % 3]);
                uses.push_back({{low, high}, facet});
            }
        }
        std::sort(uses.begin(), uses.end());
        for (std::size_t k = 1; k < uses.size(); ++k) {
            const auto& [edge, facet] = uses[k];
            if (uses[k - 1].first == edge)
                edges_.push_back(
                    {{uses[k - 1].second, facet},
                     (part_.points()[edge[1]] - part_.points()[edge[0]]).norm()});
        }
    }

    void collect_regions()
    {
        std::vector<std::vector<std::size_t>> beside(direction_of_.size());
        for (const SharedEdge& edge : edges_)
            if (direction_of_[edge.facets[0]] == direction_of_[edge.facets[1]]) {
                beside[edge.facets[0]].push_back(edge.facets[1]);
                beside[edge.facets[1]].push_back(edge.facets[0]);
            }
        constexpr std::size_t none = -1;
        std::vector<std::size_t> region_of(direction_of_.size(), none);
        for (std::size_t first = 0; first < direction_of_.size(); ++first) {
            if (!direction_of_[first] || region_of[first] != none)
                continue;
            Region region{*direction_of_[first]};
            region.facets.push_back(first);
            region_of[first] = regions_.size();
            for (std::size_t k = 0; k < region.facets.size(); ++k) {
                region.area += area_vector(part_, region.facets[k]).norm();
                for (const std::size_t next : beside[region.facets[k]])
                    if (std::exchange(region_of[next], regions_.size()) == none)
                        region.facets.push_back(next);
            }
            regions_.push_back(std::move(region));
        }
        for (const SharedEdge& edge : edges_) {
            const std::size_t a = region_of[edge.facets[0]];
            const std::size_t b = region_of[edge.facets[1]];
            if (a == b)
                continue;
            regions_[a].borders[b] += edge.length;
            regions_[b].borders[a] += edge.length;
        }
    }

    bool sees_all(std::size_t direction, const Region& region) const
    {
        return std::ranges::all_of(region.facets, [&](std::size_t facet) {
            return map_.is_accessible(facet, direction);
        });
    }

    // The direction that a region can take from its neighbours: of those that see it, the one
    // with the longest border; of equal ones the first.
    std::optional<std::size_t> other_direction(std::size_t number) const
    {
        const Region& region = regions_[number];
        std::map<std::size_t, double> borders;
        for (const auto& [other, length] : region.borders)
            borders[regions_[other].direction] += length;
        std::optional<std::size_t> best;
        for (const auto& [direction, length] : borders)
            if (direction != region.direction && (!best || length > borders[*best]) &&
                sees_all(direction, region))
                best = direction;
        return best;
    }

    std::vector<std::size_t> neighbours_along(std::size_t region,
                                              std::size_t direction) const
    {
        std::vector<std::size_t> found;
        for (const auto& [other, length] : regions_[region].borders)
            if (regions_[other].direction == direction)
                found.push_back(other);
        return found;
    }

    // Makes `other` a part of `region`.
    void absorb(std::size_t region, std::size_t other)
    {
        Region& into = regions_[region];
        Region from = std::exchange(regions_[other], Region{});
        into.area += from.area;
        if (into.facets.size() < from.facets.size())
            into.facets.swap(from.facets);
        into.facets.insert(into.facets.end(), from.facets.begin(), from.facets.end());
        into.borders.erase(other);
        for (const auto& [third, length] : from.borders) {
            if (third == region)
                continue;
            into.borders[third] += length;
            regions_[third].borders.erase(other);
            regions_[third].borders[region] += length;
        }
    }

    const TriangleMesh& part_;
    const VisibilityMap& map_;
    std::vector<std::optional<std::size_t>>& direction_of_;
    std::vector<SharedEdge> edges_;
    std::vector<Region> regions_;
};

}  // namespace

std::vector<std::size_t> SetupRegions::facets_of(std::size_t direction) const
{
    std::vector<std::size_t> facets;
    for (std::size_t facet = 0; facet < direction_of.size(); ++facet)
        if (direction_of[facet] == direction)
            facets.push_back(facet);
    return facets;
}

SetupRegions setup_regions(const TriangleMesh& part, std::span<const Vec3> directions,
                           const SetupRegionOptions& options)
{
    require(!directions.empty(), "setup_regions: need at least one direction");
    require(std::isfinite(options.cutter_radius) && options.cutter_radius > 0,
            "setup_regions: need a cutter radius above 0");
    const std::size_t facets = part.triangles().size();
    require(std::ranges::all_of(options.skipped,
                                [&](std::size_t facet) { return facet < facets; }),
            "setup_regions: need skipped facets of the part");
    PartVisibility visibility = part_visibility(part, directions);
    std::vector<char> is_left_out(facets, 0);
    for (const std::size_t facet : options.skipped)
        is_left_out[facet] = 1;
    for (const std::size_t facet : visibility.dropped)
        is_left_out[facet] = 1;
    SetupRegions regions;
    regions.direction_of.resize(facets);
    for (std::size_t facet = 0; facet < facets; ++facet) {
        if (is_left_out[facet] != 0)
            continue;
        const Vec3 normal = area_vector(part, facet).normalized();
        const auto is_seen = [&](std::size_t direction) {
            return visibility.map.is_accessible(facet, direction);
        };
        std::optional<std::size_t>& direction = regions.direction_of[facet];
        if (options.reaches)
            direction = best_direction(normal, directions, [&](std::size_t k) {
                return is_seen(k) && options.reaches(facet, k);
            });
        if (!direction)
            direction = best_direction(normal, directions, is_seen);
        if (!direction)
            regions.uncovered.push_back(facet);
    }
    const double side = 2 * options.cutter_radius;
    regions.joined_regions =
        RegionGraph{part, visibility.map, regions.direction_of}.join_below(side * side);
    regions.seen = std::move(visibility.map);
    return regions;
}

}  // namespace endmill
