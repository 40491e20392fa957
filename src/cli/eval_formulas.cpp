// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_formulas.h"

#include <array>

#include "cli/console.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"

namespace endmill {
namespace {

constexpr Argument radius{"radius", "MM", "radius of the ball", true};
constexpr Argument curvature{
    "curvature", "PER_MM", "normal curvature, positive where the part is convex", false};
constexpr Argument scallop{"scallop", "MM", "scallop height, below the ball's diameter",
                           true};

// Null if the result is Unlimited: its lengths are infinite and have no angle.
Json half_angle(const Angle& angle, LengthStatus status)
{
    return status == LengthStatus::Unlimited ? Json(nullptr) : Json(angle.radians());
}

Json path_interval_json(const Numbers& numbers)
{
    const PathInterval interval = path_interval(
        BallCutter{numbers.at("radius")}, numbers.at("curvature"), numbers.at("scallop"));
    return {{"chord_mm", finite_or_null(interval.chord)},
            {"projected_mm", finite_or_null(interval.projected)},
            {"arc_mm", finite_or_null(interval.arc)},
            {"half_angle_rad", half_angle(interval.half_angle, interval.status)},
            {"status", length_status_name(interval.status)}};
}

Json step_length_json(const Numbers& numbers)
{
    const StepLength step =
        step_length(numbers.at("curvature"), numbers.at("chord-tolerance"));
    return {{"chord_mm", finite_or_null(step.chord)},
            {"projected_mm", finite_or_null(step.projected)},
            {"half_angle_rad", half_angle(step.half_angle, step.status)},
            {"status", length_status_name(step.status)}};
}

Json scallop_height_json(const Numbers& numbers)
{
    return {
        {"scallop_mm", scallop_height(BallCutter{numbers.at("radius")},
                                      numbers.at("curvature"), numbers.at("interval"))}};
}

Json highest_scallop_json(const Numbers& numbers)
{
    return {
        {"scallop_mm", finite_or_null(highest_scallop(BallCutter{numbers.at("radius")},
                                                      numbers.at("curvature")))}};
}

const std::array formulas{
    Formula{"path-interval",
            "largest interval between passes for a scallop height (Kim and Choi, eq. "
            "(4), (5))",
            "--radius 5 --curvature 0.01 --scallop 0.1",
            {radius, curvature, scallop},
            path_interval_json},
    Formula{
        "step-length",
        "longest step within a chord tolerance (Kim and Choi, eq. (1), (2))",
        "--curvature 0.01 --chord-tolerance 0.5",
        {curvature,
         {"chord-tolerance", "MM", "largest distance from the curve to its chord", true}},
        step_length_json},
    Formula{"scallop-height",
            "scallop height between passes, the inverse of path-interval",
            "--radius 7.5 --curvature 0.02 --interval 5",
            {radius, curvature, {"interval", "MM", "distance of two contacts", true}},
            scallop_height_json},
    Formula{"highest-scallop",
            "largest scallop height that neighbouring passes can leave",
            "--radius 5 --curvature 0.1",
            {radius, curvature},
            highest_scallop_json},
};

}  // namespace

std::span<const Formula> eval_formulas()
{
    return formulas;
}

}  // namespace endmill
