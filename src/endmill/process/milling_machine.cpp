// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/milling_data.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

void require_sound(const MachineLimits& machine)
{
    for (const auto& limit :
         {machine.max_rpm, machine.max_power_w, machine.max_torque_n_m,
          machine.max_feed_mm_per_min, machine.acceleration_m_per_s2})
        require(!limit || (std::isfinite(*limit) && *limit > 0),
                "MachineLimits: need 0 < limit");
}

}  // namespace endmill
