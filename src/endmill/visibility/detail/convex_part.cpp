// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/visibility/detail/convex_part.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {

ConvexPart convex_part(const std::string& word, Angle incidence)
{
    require(0 < incidence.degrees() && incidence.degrees() < 90,
            "convex_part: need an incidence of 0 to 90 degrees, exclusive");
    const bool is_cube = word == "cube";
    require(is_cube || word == "prism", "convex_part: need cube or prism");
    ConvexPart part{{Vec3::UnitZ()}, incidence};
    const int sides = is_cube ? 4 : 6;
    for (int k = 0; k < sides; ++k) {
        const double azimuth = 2 * std::numbers::pi * k / sides;
        part.normals.emplace_back(std::cos(azimuth), std::sin(azimuth), 0);
    }
    // Both directions lean as far from the top as its cap allows: on opposite sides, over
    // an edge of the cube or over a side of the prism.
    const double reach = std::cos(incidence.radians());
    part.shortest_arc =
        Angle::radians(2 * std::asin((is_cube ? std::numbers::sqrt2 : 2) * reach));
    return part;
}

VisibilityMap cap_map(const ConvexPart& part, const SphereGrid& grid)
{
    VisibilityMap map{part.normals.size(), grid.centres.size()};
    const double least_cosine = std::cos(part.incidence.radians());
    for (std::size_t i = 0; i < map.cells(); ++i)
        for (std::size_t j = 0; j < map.facets(); ++j)
            if (part.normals[j].dot(grid.centres[i]) > least_cosine)
                map.column(i)[j / 64] |= std::uint64_t{1} << j % 64;
    return map;
}

double shortest_arc_of_two(const VisibilityMap& map, const SphereGrid& grid)
{
    std::uint64_t all = 0;
    for (std::size_t i = 0; i < map.cells(); ++i)
        all |= map.column(i)[0];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < map.cells(); ++i)
        for (std::size_t k = 0; k < i; ++k)
            if ((map.column(i)[0] | map.column(k)[0]) == all)
                least = std::min(least, (grid.centres[i] - grid.centres[k]).norm());
    return 2 * std::asin(std::min(least / 2, 1.0));
}

}  // namespace endmill
