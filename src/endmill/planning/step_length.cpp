// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/step_length.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {

std::string_view length_status_name(LengthStatus status)
{
    switch (status) {
        case LengthStatus::Ok:
            return "ok";
        case LengthStatus::Clamped:
            return "clamped";
        case LengthStatus::Unlimited:
            return "unlimited";
    }
    return {};
}

StepLength step_length(double curvature, double chord_tolerance)
{
    const double k = std::abs(curvature);
    const double delta = chord_tolerance;
    require(std::isfinite(k), "step_length: the curvature must be finite");
    require(std::isfinite(delta) && delta > 0, "step_length: need 0 < chord tolerance");

    constexpr double infinity = std::numeric_limits<double>::infinity();
    // k delta at a half angle of 45 degrees.
    constexpr double most_sagitta = 1 - std::numbers::sqrt2 / 2;
    if (k * delta > most_sagitta)
        return {std::numbers::sqrt2 / k, 1 / k, Angle::degrees(45),
                LengthStatus::Clamped};
    const double chord = 2 * std::sqrt(delta * (2 / k - delta));
    // k is zero, or so small that 1/k overflows.
    if (!(chord < infinity))
        return {infinity, infinity, Angle::radians(0), LengthStatus::Unlimited};
    // Equal to acos(1 - k delta), which would cancel for small angles.
    const Angle half_angle = Angle::radians(2 * std::asin(std::sqrt(k * delta / 2)));
    return {chord, chord * (1 - k * delta), half_angle, LengthStatus::Ok};
}

}  // namespace endmill
