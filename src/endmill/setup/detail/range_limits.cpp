// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/range_limits.h"

namespace endmill {

RangeLimits::RangeLimits(RotaryFamily family, const RotaryLimits& limits)
{
    const bool is_ca = family == RotaryFamily::CA;
    const RotaryRange& window = is_ca ? limits.theta : limits.phi;
    const RotaryRange& reach = is_ca ? limits.phi : limits.theta;
    const double most = is_ca ? std::numbers::pi : std::numbers::pi / 2;
    width = std::min(window.to - window.from, 2 * std::numbers::pi);
    far = std::min(std::max(reach.to, -reach.from), most);
    near = std::min(std::min(reach.to, -reach.from), most);
}

}  // namespace endmill
