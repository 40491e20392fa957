// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/several_setups.h"

namespace endmill::test {

/// Whether the machine takes the direction, from the angles themselves.
inline bool takes(const SetupReach& reach, const RotaryFrame& frame,
                  const Vec3& direction)
{
    const RotaryAngles angles = rotary_angles(frame, direction);
    if (reach.axes == 4) {
        const double off =
            std::asin(std::min(std::abs(direction.dot(frame.r1_axis)), 1.0));
        return off <= reach.arc_tolerance.radians() + turn_tolerance &&
               turn_within(reach.limits.phi, angles.phi);
    }
    const auto holds = [&](const RotaryAngles& turns) {
        return turn_within(reach.limits.phi, turns.phi) &&
               turn_within(reach.limits.theta, turns.theta);
    };
    return holds(angles) || (frame.family == RotaryFamily::CA &&
                             holds(other_rotary_angles(frame.family, angles)));
}

/// Machines of each kind, with narrow, wide, one-sided limits, and some beyond half a turn.
inline std::vector<SetupReach> reaches()
{
    std::vector<SetupReach> all{{.axes = 3}};
    const std::vector<RotaryRange> ranges{{-0.4, 0.9}, {0, 1.1}, {-3.5, 0.2},
                                          {-0.3, 5},   {0, 0},   {}};
    for (const RotaryRange& phi : ranges)
        for (const RotaryRange& theta : ranges)
            for (const bool is_b_first : {false, true}) {
                all.push_back({.axes = 4, .limits = {phi, theta}});
                all.push_back({.family = RotaryFamily::AB,
                               .is_b_first = is_b_first,
                               .limits = {phi, theta}});
                all.push_back({.family = RotaryFamily::CA, .limits = {phi, theta}});
            }
    return all;
}

}  // namespace endmill::test
