// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <algorithm>
#include <cmath>

namespace endmill {

std::array<double, 2> magnitudes(const RotaryRange& range)
{
    const double one = std::abs(range.from);
    const double other = std::abs(range.to);
    return {std::min(one, other), std::max(one, other)};
}

RotaryOrder rotary_order(const MachineConfiguration& configuration)
{
    const bool is_b_first = configuration.family && configuration.rotary[0].letter == 'b';
    return is_b_first ? RotaryOrder::BFirst : RotaryOrder::AFirst;
}

RotaryFrame pose_frame(const MachineConfiguration& configuration, const SetupPose& pose)
{
    return {configuration.family.value_or(RotaryFamily::AB), pose.tool_axis, pose.r1_axis,
            pose.r2_axis};
}

RotaryLimits reach_limits(const RotaryReach& reach)
{
    RotaryLimits limits = reach.limits;
    if (!reach.configuration.family) {
        const double tolerance = reach.arc_tolerance.radians();
        const double aside = reach.configuration.rotary.empty() ? 0 : tolerance;
        limits.theta = {-aside, aside};
    }
    return limits;
}

}  // namespace endmill
