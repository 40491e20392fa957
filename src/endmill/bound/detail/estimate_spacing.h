// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "endmill/bound/bound_problem.h"
#include "endmill/core/error.h"

namespace endmill {

/// The spacing of nodes in mm on surfaces by default: 0.35 to 0.7 of the width of the disc on a
/// plane, so that a part has about 4000 nodes.
/// \param area of the part, mm^2.
inline double surface_spacing(double area, const BoundProblem& problem)
{
    constexpr double widest_share = 0.7;
    constexpr double narrowest_share = 0.35;
    constexpr double usual_nodes = 4000;
    const double width = 2 * plane_half_width(problem);
    return std::clamp(std::sqrt(area / usual_nodes), narrowest_share * width,
                      widest_share * width);
}

/// Checks the options of an estimate.
/// \param area of the part, mm^2.
/// \param wanted spacing of nodes in mm.
/// \param random_places of a test.
/// \return the spacing of nodes in mm, never so small that a part has above 30 000.
/// \throws DomainError if an option is out of range.
inline double estimate_spacing(double area, double wanted, std::size_t random_places)
{
    constexpr std::size_t least_random_places = 1000;
    constexpr double most_nodes = 30000;  // at 6 kB each
    require(random_places >= least_random_places,
            "path_bound: need at least 1000 random places");
    require(std::isfinite(wanted) && wanted > 0,
            "path_bound: the spacing of nodes must be positive");
    return std::max(wanted, std::sqrt(area / most_nodes));
}

/// The bound for paths of at most m pieces; nothing unless it is positive.
inline std::optional<double> positive_bound(double density, double disc, int most_pieces)
{
    const double bound = density - most_pieces * disc;
    return bound > 0 ? std::optional{bound} : std::nullopt;
}

}  // namespace endmill
