// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <algorithm>
#include <limits>

namespace endmill {
namespace {

/// Relative error bound of the results: a few roundings of 1.1e-16 each.
constexpr double measure_rounding = 1e-14;

}  // namespace

PoseRanges pose_ranges(RotaryFamily family, const FittedPose& fit)
{
    const bool is_ca = family == RotaryFamily::CA;
    const RotaryRange& window = is_ca ? fit.theta : fit.phi;
    const RotaryRange& other = is_ca ? fit.phi : fit.theta;
    return {window.to - window.from, other.to, -other.from};
}

double PoseMeasure::operator()(const PoseRanges& ranges) const
{
    switch (objective) {
        case SetupObjective::FlooredArea:
            return (ranges.width + floor_rad) * (ranges.height() + floor_rad);
        case SetupObjective::TotalRange:
            return ranges.width + ranges.height();
        case SetupObjective::Tilt:
            break;
    }
    const double tilt = std::max(ranges.m0, ranges.m1);
    return family == RotaryFamily::CA ? tilt : std::max(tilt, ranges.width / 2);
}

double PoseMeasure::useful_width(double target, double m0, double m1) const
{
    if (objective != SetupObjective::Tilt)
        return useful_height(target, m0 + m1);  // symmetric in width and height
    if (std::max(m0, m1) >= target)
        return -1;
    return family == RotaryFamily::CA ? std::numeric_limits<double>::infinity()
                                      : 2 * target * (1 + measure_rounding);
}

double PoseMeasure::useful_height(double target, double width) const
{
    const double rest = objective == SetupObjective::FlooredArea
                            ? target / (width + floor_rad) - floor_rad
                            : target - width;
    return rest + measure_rounding * (1 + std::abs(rest));
}

}  // namespace endmill
