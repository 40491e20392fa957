// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Forces of a ball-end mill: means over a spindle revolution, forces at positions within
/// a revolution, and the ratio of the largest to the mean.

#include <span>
#include <vector>

#include "endmill/process/cutting_coefficients.h"
#include "endmill/process/milling_data.h"

namespace endmill {

/// Cutting force and torque in the frame of BallEngagement: x along the feed as seen from
/// above, y across the feed towards the stock (to the left of the feed when milling up,
/// to the right when milling down), z upwards.
///
/// The horizontal components act on the work. The axial component is the thrust on the
/// cutter.
/// Source: docs/methods/ball-end-milling.md, section 1.
struct CuttingForce {
    double x_n;         ///< N, on the work
    double y_n;         ///< N, on the work
    double z_n;         ///< N, on the cutter, upwards
    double torque_n_m;  ///< N m about the axis; positive when milling up, else negative
};

/// Means of force and torque of all teeth over a spindle revolution:
///
///     Fx = m r0 K [ f (s I1 + r1 I2) + h (s I3 + r2 I4) ]
///     Fy = m r0 K [ f (r1 I1 - s I2) + h (r2 I3 - s I4) ]
///     Fz = m r0 K [ f r3 I5 + h r4 I6 ]
///     Mt = s m r0^2 K [ f I7 + h I8 ]
///
/// with s = 1 when milling up and s = -1 when milling down.
/// Source: [ParkMaeng, eq. (1), appendices A and B], with misprints corrected as in
/// docs/methods/ball-end-milling.md, section 2.
/// \param coefficients of the engagement, from `cutting_coefficients`.
/// \param material K, h, r1 to r4.
/// \param tool m and r0.
/// \param feed_per_tooth_mm f in mm, at least 0.
/// \param milling side of the feed on which the stock lies.
/// \throws DomainError for a negative feed, or unless `material` and `tool` are sound.
/// Relative error below 1e-15 of the sum of the magnitudes of the terms.
CuttingForce mean_force(const CuttingCoefficients& coefficients,
                        const CuttingMaterial& material, const MillingTool& tool,
                        double feed_per_tooth_mm, Milling milling);

/// Radial runout: offset of the cutter's axis from the spindle's axis.
struct Runout {
    double offset_mm = 0;  ///< mm, at least 0
    double angle = 0;  ///< rad: azimuth of the offset when flute 0 stands at azimuth 0
};

/// A cut whose force is computed at positions within a spindle revolution.
struct MillingCut {
    BallEngagement engagement;          ///< how the ball meets the stock
    ChipModel chip = ChipModel::Paper;  ///< definition of the chip thickness
    CuttingMaterial material;           ///< force constants of the material
    MillingTool tool;                   ///< radius, flutes, helix
    double feed_per_tooth_mm;           ///< mm, at least 0
    Milling milling = Milling::Down;    ///< side of the feed on which the stock lies
    Runout runout = {};                 ///< none by default
};

/// Force and torque of a ball-end mill with helical flutes at given positions within a
/// spindle revolution.
///
/// Azimuths and the sense of the helix are those of MillingTool::helix. When milling down
/// the frame is mirrored: a right-hand cutter under M03 has a negative helix and rotates
/// towards falling azimuths.
///
/// Flutes are counted in cutting order: flute j stands 2 pi j / m behind flute 0. Without
/// runout the thickness of its chip is f |sin u|, or that of the exact chip. Runout e at
/// the angle a adds e [cos(2 pi j / m - a) - cos(2 pi (j - 1) / m - a)]. This is the
/// distance by which the flute reaches beyond the flute before it. Where the sum is
/// negative, the flute does not touch the work and bears no force. If every chip is
/// positive, the mean over a revolution equals `mean_force` for any helix.
/// Source: [ParkMaeng, appendices A and B], with misprints corrected; the runout model is
/// described in docs/methods/ball-end-milling.md, section 10.
///
/// \param cut the cut.
/// \param turns azimuths of the tip of flute 0, in rad, any values.
/// \return one force per entry of `turns`. Relative error below 1e-9 of the largest
///         force.
/// \throws DomainError unless `cut` is sound, or if its flutes wind more than 1000 times
///         about the axis below the stock's top.
std::vector<CuttingForce> force_profile(const MillingCut& cut,
                                        std::span<const double> turns);

/// Peak factor R_m: the largest torque of the chip in a spindle revolution divided by its
/// mean, for all flutes of a helical ball-end mill together. It is 1 if nothing is cut.
/// Relative error below 1e-6.
/// Source: docs/methods/ball-end-milling.md, section 4.
/// \throws DomainError unless `engagement` and `tool` are sound, or if the flutes wind
///         more than 1000 times about the axis below the stock's top.
double peak_factor(const BallEngagement& engagement, ChipModel chip,
                   const MillingTool& tool);

}  // namespace endmill
