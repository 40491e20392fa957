// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/axis_limits.h"

#include <algorithm>
#include <numbers>

namespace endmill {
namespace {

// Tests whether the turn of the axis is theta: that of the first axis of C,A and of the
// second axis of A,B. A single axis is phi.
bool is_theta(const MachineConfiguration& configuration, std::size_t axis)
{
    return (configuration.family == RotaryFamily::CA) == (axis == 0);
}

}  // namespace

bool is_within(const LinearLimits& limits, const Vec3& xyz)
{
    for (std::size_t k = 0; k < limits.size(); ++k) {
        const double at = xyz[static_cast<Eigen::Index>(k)];
        if (!(limits[k].from <= at && at <= limits[k].to))
            return false;
    }
    return true;
}

std::optional<double> turn_within(const RotaryRange& range, double turn)
{
    for (const int turns : {0, -1, 1}) {
        const double same = turn + 2 * std::numbers::pi * turns;
        if (same >= range.from - turn_tolerance && same <= range.to + turn_tolerance)
            return same;
    }
    return std::nullopt;
}

double mirrored(MachineSide side, double turn)
{
    return side == MachineSide::Table ? 0 - turn : turn;
}

RotaryRange mirrored(MachineSide side, const RotaryRange& range)
{
    return side == MachineSide::Table ? RotaryRange{0 - range.to, 0 - range.from} : range;
}

std::optional<std::string> expected_rotary_range(std::size_t axis, double from_deg,
                                                 double to_deg)
{
    if (!(from_deg <= 0 && 0 <= to_deg))
        return "limits that hold 0, the lower one first";
    if (axis == 0 && !(to_deg - from_deg <= 360))
        return "limits at most 360 degrees apart; an axis without limits is not limited";
    if (axis > 0 && !(from_deg >= -180 && to_deg <= 180))
        return "limits within 180 degrees either way, the axis being next to the tool";
    return std::nullopt;
}

RotaryRange within_one_rotation(std::size_t axis, const RotaryRange& range)
{
    constexpr double pi = std::numbers::pi;
    if (axis == 0)
        return range.to - range.from > 2 * pi ? RotaryRange{-pi, pi} : range;
    return {std::max(range.from, -pi), std::min(range.to, pi)};
}

RotaryRange& turns_of(RotaryLimits& limits, const MachineConfiguration& configuration,
                      std::size_t axis)
{
    return is_theta(configuration, axis) ? limits.theta : limits.phi;
}

const RotaryRange& turns_of(const RotaryLimits& limits,
                            const MachineConfiguration& configuration, std::size_t axis)
{
    return is_theta(configuration, axis) ? limits.theta : limits.phi;
}

RotaryLimits widest_limits(const MachineConfiguration& configuration)
{
    RotaryLimits limits;
    if (configuration.rotary.size() < 2)
        limits.theta = {0, 0};
    if (configuration.rotary.empty())
        limits.phi = {0, 0};
    return limits;
}

}  // namespace endmill
