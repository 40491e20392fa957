// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/milling_data.h"

// Materials, tools and machines for several tests of the module.
namespace endmill::test {

/// The steel of docs/methods/ball-end-milling.md, section 8, in N; 1 kgf = 9.80665 N.
inline CuttingMaterial steel()
{
    return {.specific_resistance_n_per_mm2 = 204 * 9.80665,
            .edge_thickness_mm = 0.016,
            .r1 = 0.4,
            .r2 = 0.4,
            .r3 = 0.2,
            .r4 = 0.6,
            .alpha = 0.3680141,
            .v1_m_per_min = 28.4313,
            .max_feed_per_tooth_mm = 0.15,
            .min_feed_per_tooth_mm = 0.005,
            .name = "steel"};
}

/// The cutter of the same section.
inline MillingTool ball_10()
{
    return {.radius = 5,
            .flutes = 2,
            .helix = 0.5235987755982988,  // 30 degrees
            .limits = {.cutting_force_n = 128.3 * 9.80665,
                       .thrust_n = 46.19 * 9.80665,
                       .torque_n_m = 2 * 9.80665}};
}

/// The machine for steel of the same section.
inline MachineLimits mill_3000()
{
    return {.max_rpm = 3000, .max_power_w = 3700, .max_feed_mm_per_min = 2000};
}

}  // namespace endmill::test
