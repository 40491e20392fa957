// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/detail/feasible_turns.h"

namespace endmill::test {

/// Tests whether the machine takes a direction, from the angles themselves.
inline bool takes(const RotaryReach& reach, const RotaryFrame& frame,
                  const Vec3& direction)
{
    const RotaryAngles angles = rotary_angles(frame, direction);
    if (!reach.configuration.family) {
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

/// Machines of each kind with narrow, wide and one-sided limits, some of them beyond half
/// a turn.
inline std::vector<RotaryReach> reaches()
{
    std::vector<RotaryReach> all{{.configuration = configuration_from_word("W/xyBz/T")}};
    const std::vector<RotaryRange> ranges{{-0.4, 0.9}, {0, 1.1}, {-3.5, 0.2},
                                          {-0.3, 5},   {0, 0},   {}};
    for (const RotaryRange& phi : ranges)
        for (const RotaryRange& theta : ranges)
            for (const char* word :
                 {"W/aBxyz/T", "W/abBxyz/T", "W/baBxyz/T", "W/caBxyz/T"})
                all.push_back({.configuration = configuration_from_word(word),
                               .limits = {phi, theta}});
    return all;
}

}  // namespace endmill::test
