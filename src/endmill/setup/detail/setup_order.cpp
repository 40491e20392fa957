// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/setup_order.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "endmill/setup/detail/pole_points.h"

namespace endmill {
namespace {

// The rounding of an area, some 1e-15 of it, with room for how a limit is met.
constexpr double equal_scores = 1e-9;

constexpr double degree = std::numbers::pi / 180;  // rad

double width(const RotaryRange& range)
{
    return range.to - range.from;
}

struct Magnitudes {
    double larger;
    double smaller;
};

Magnitudes magnitudes(const RotaryRange& range)
{
    const double from = std::abs(range.from);
    const double to = std::abs(range.to);
    return {std::max(from, to), std::min(from, to)};
}

}  // namespace

double equal_area_limit(double area)
{
    return area + equal_scores * std::max(area, square_degree);
}

double equal_sum_limit(double sum)
{
    return sum + equal_scores * std::max(sum, degree);
}

SetupScore score_of(const FittedPose& fit)
{
    return {fit.area, width(fit.phi) + width(fit.theta)};
}

RotaryRange turned(const RotaryRange& range)
{
    return {0 - range.to, 0 - range.from};  // not -0
}

bool is_within(const RotaryRange& range, const RotaryRange& limits)
{
    return limits.from - equal_angles <= range.from &&
           range.to <= limits.to + equal_angles;
}

bool is_within_unsigned(const RotaryRange& range, const RotaryRange& limits)
{
    const Magnitudes asked = magnitudes(range);
    const Magnitudes given = magnitudes(limits);
    return asked.larger <= given.larger + equal_angles &&
           asked.smaller <= given.smaller + equal_angles;
}

SetupStatus status_of(const FittedPose& fit)
{
    const bool has_phi = width(fit.phi) > equal_angles;
    const bool has_theta = width(fit.theta) > equal_angles;
    if (has_phi && has_theta)
        return SetupStatus::Ok;
    return has_phi || has_theta ? SetupStatus::FourAxis : SetupStatus::ThreeAxis;
}

}  // namespace endmill
