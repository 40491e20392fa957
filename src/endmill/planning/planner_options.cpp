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

std::optional<double> fitting_diameter(const std::optional<double>& requested,
                                       const std::optional<CutterLimit>& limit)
{
    if (!requested)
        return default_diameter(limit);
    return fits(BallCutter{*requested / 2}, limit) ? requested : std::nullopt;
}

double default_tolerance(const BallCutter& ball)
{
    return 2 * ball.radius() / tolerances_per_diameter;
}

PlanTolerances plan_tolerances(const RequestedTolerances& requested, Planner planner,
                               const BallCutter& ball)
{
    const double chord = requested.chord.value_or(
        planner == Planner::Paper ? default_tolerance(ball) : verified_tolerance);
    return {chord,
            requested.scallop_height.value_or(chord),
            {requested.inner.value_or(chord), requested.outer.value_or(chord)}};
}

double default_safe_height(std::span<const Surface> surfaces, const Vec3& axis)
{
    return extent(surfaces, axis).high + clearance;
}

}  // namespace endmill
