// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/rectangle_candidate.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include "endmill/setup/detail/pole_points.h"
#include "endmill/setup/detail/setup_order.h"

namespace endmill {

RectangleCandidate rectangle_about(const Vec3& tool_axis, const Vec3& r1_axis,
                                   std::span<const Vec3> directions)
{
    const Vec3 r2 = tool_axis.cross(r1_axis);
    RectangleCandidate found{r1_axis, {0, 0}, {0, 0}, RectangleOrigin::Search};
    for (const Vec3& v : directions) {
        const double sine = v.dot(r1_axis);
        const double beta = std::asin(std::clamp(sine, -1.0, 1.0));
        found.beta = {std::min(found.beta.from, beta), std::max(found.beta.to, beta)};
        const double height = v.dot(tool_axis);
        const double side = -v.dot(r2);
        if (std::hypot(side, height) <= equal_angles)
            continue;
        const double alpha = std::atan2(side, height);
        found.alpha = {std::min(found.alpha.from, alpha),
                       std::max(found.alpha.to, alpha)};
    }
    return found;
}

bool fits_rigidly(const RectangleCandidate& rectangle, const RotaryLimits& limits)
{
    return (is_within(rectangle.alpha, limits.phi) &&
            is_within(rectangle.beta, limits.theta)) ||
           (is_within(turned(rectangle.alpha), limits.phi) &&
            is_within(turned(rectangle.beta), limits.theta));
}

}  // namespace endmill
