// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/setup_order.h"

#include <algorithm>
#include <numbers>

#include "endmill/setup/detail/pole_points.h"

namespace endmill {
namespace {

// Relative tolerance of equal areas and sums. Their rounding is 1e-15; limits are met to
// `equal_angles`, which moves an area by as much.
constexpr double equal_scores = 1e-9;

constexpr double degree = std::numbers::pi / 180;  // rad

double width(const RotaryRange& range)
{
    return range.to - range.from;
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
    return {0 - range.to, 0 - range.from};  // a difference, so that 0 does not become -0
}

bool is_within(const RotaryRange& range, const RotaryRange& limits)
{
    return limits.from - equal_angles <= range.from &&
           range.to <= limits.to + equal_angles;
}

bool is_within_unsigned(const RotaryRange& range, const RotaryRange& limits)
{
    const auto [smaller, larger] = magnitudes(range);
    const auto [smaller_limit, larger_limit] = magnitudes(limits);
    return larger <= larger_limit + equal_angles &&
           smaller <= smaller_limit + equal_angles;
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
