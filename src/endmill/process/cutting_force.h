// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// On which side of the feed the stock is, for a spindle that turns clockwise seen from above.
enum class Milling {
    Up,   ///< to the left: the chip begins thin
    Down  ///< to the right: the chip ends thin
};

/// Force and torque of the tool on the work, in the frame of BallEngagement: x along the feed
/// as seen from above, y across it towards the stock (to the left of the feed when milling
/// up, to the right when milling down), z upwards.
struct CuttingForce {
    double x_n;         ///< N
    double y_n;         ///< N
    double z_n;         ///< N
    double torque_n_m;  ///< N m about the axis; positive when milling up
};

/// Means over a turn of the force and torque of all teeth at a feed per tooth:
///
///     Fx = m r0 K [ f (s I1 + r1 I2) + h (s I3 + r2 I4) ]    Fz = m r0 K [ f r3 I5 + h r4 I6 ]
///     Fy = m r0 K [ f (r1 I1 - s I2) + h (r2 I3 - s I4) ]    Mt = s m r0^2 K [ f I7 + h I8 ]
///
/// with s = 1 when milling up and -1 when milling down.
/// Source: [ParkMaeng, eq. (1), appendices A and B], misprints corrected.
/// \param coefficients of the engagement, as `cutting_coefficients` gives them.
/// \param feed_per_tooth_mm f, from 0.
/// \throws DomainError for a negative feed, or unless `material` and `tool` are sound.
/// Relative error below 1e-15 of the sum of the terms' magnitudes.
CuttingForce mean_force(const CuttingCoefficients& coefficients,
                        const CuttingMaterial& material, const MillingTool& tool,
                        double feed_per_tooth_mm, Milling milling);

}  // namespace endmill
