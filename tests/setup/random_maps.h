// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>

#include "endmill/core/vec.h"
#include "endmill/visibility/visibility.h"
#include "random.h"

namespace endmill::test {

inline Vec3 random_direction(Random& random)
{
    const double z = random.uniform(-1, 1);
    const double azimuth = random.uniform(0, 2 * std::numbers::pi);
    const double rho = std::sqrt(1 - z * z);
    return {rho * std::cos(azimuth), rho * std::sin(azimuth), z};
}

inline void make_accessible(VisibilityMap& map, std::size_t facet, std::size_t cell)
{
    map.column(cell)[facet / 64] |= std::uint64_t{1} << (facet % 64);
}

/// Cones that are random caps of 10 to 60 degrees. Two of every four facets have the same
/// cone, and every ninth facet has an empty one.
inline VisibilityMap random_caps(std::size_t facets, std::span<const Vec3> centres,
                                 Random& random)
{
    VisibilityMap map{facets, centres.size()};
    Vec3 axis = Vec3::UnitZ();
    double least = 0;
    for (std::size_t facet = 0; facet < facets; ++facet) {
        if (facet % 4 != 1) {
            axis = random_direction(random);
            least = std::cos(random.uniform(10, 60) * std::numbers::pi / 180);
        }
        for (std::size_t cell = 0; facet % 9 != 8 && cell < centres.size(); ++cell)
            if (axis.dot(centres[cell]) > least)
                make_accessible(map, facet, cell);
    }
    return map;
}

}  // namespace endmill::test
