// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/planner_options.h"

#include "endmill/surface/extent.h"

namespace endmill {
namespace {

// Diameter of the ball per tolerance: 15 mm per 0.5 mm in the paper's figure 12.
constexpr double tolerances_per_diameter = 30;
// Distance in mm between the tip at the safe height and the highest point of the part.
constexpr double clearance = 5;

}  // namespace

bool fits(const BallCutter& ball, const std::optional<CutterLimit>& limit)
{
    return !limit || ball.radius() < limit->radius_mm;
}

std::optional<double> default_diameter(const std::optional<CutterLimit>& limit)
{
    for (const double diameter : stock_diameters)
        if (fits(BallCutter{diameter / 2}, limit))
            return diameter;
    return std::nullopt;
}

double default_tolerance(const BallCutter& ball)
{
    return 2 * ball.radius() / tolerances_per_diameter;
}

double default_safe_height(std::span<const Surface> surfaces, const Vec3& axis)
{
    return extent(surfaces, axis).high + clearance;
}

}  // namespace endmill
