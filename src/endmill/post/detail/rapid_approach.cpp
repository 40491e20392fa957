// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/rapid_approach.h"

#include <cmath>

#include "endmill/core/error.h"
#include "endmill/post/detail/descent.h"

namespace endmill {
namespace {

// Adds the points of a descent that is a rapid down to `height`. Points above that height
// are left out.
void add_descent(ToolPath& result, const ToolPath& path, const Descent& descent,
                 double height)
{
    PathPoint rapid = path.points[descent.first];
    rapid.move = Move::Rapid;
    rapid.known_contact = {};
    rapid.location.tip.z() = height;
    result.points.push_back(rapid);
    for (std::size_t k = descent.first; k <= descent.last; ++k) {
        if (path.points[k].location.tip.z() >= height)
            continue;
        result.points.push_back(path.points[k]);
        result.points.back().move = Move::Plunge;
    }
}

}  // namespace

ToolPath with_rapid_approach(const ToolPath& path, double start_height, double distance)
{
    require(std::isfinite(distance) && distance > 0,
            "with_rapid_approach: need a distance above 0");
    ToolPath result;
    result.points.reserve(path.points.size());
    for (std::size_t k = 0; k < path.points.size(); ++k) {
        const auto descent = descent_at(path, k, start_height);
        const bool is_shortened = descent && leads_to_cut(path, *descent) &&
                                  descent->to + distance < descent->from;
        if (!is_shortened) {
            result.points.push_back(path.points[k]);
            continue;
        }
        add_descent(result, path, *descent, descent->to + distance);
        k = descent->last;
    }
    return result;
}

}  // namespace endmill
