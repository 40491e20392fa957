// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Constants of the work material, the cutter and the machine, as the cutting model needs
/// them.

#include <numbers>
#include <optional>
#include <string>

#include "endmill/cutter/tool.h"

namespace endmill {

/// Force constants and cutting speeds of a work material.
///
/// An element of the edge of height dz under a chip of thickness t bears the tangential
/// force K (t + h*) dz, the radial force K (r1 t + r2 h*) dz and the axial force
/// K (r3 t + r4 h*) dz. In the notation of mechanistic force models K = K_tc,
/// h* = K_te/K_tc, r1 = K_rc/K_tc, r2 = K_re/K_te, r3 = K_ac/K_tc and r4 = K_ae/K_te.
/// Source: [ParkMaeng, eq. (1), (4)], corrected as in
/// docs/methods/ball-end-milling.md, section 2.
struct CuttingMaterial {
    double specific_resistance_n_per_mm2;  ///< N/mm^2, K, above 0
    double edge_thickness_mm;              ///< mm, h*, at least 0
    double r1;            ///< radial over tangential force of the chip, at least 0
    double r2;            ///< radial over tangential edge force, at least 0
    double r3;            ///< axial over tangential force of the chip, at least 0
    double r4;            ///< axial over tangential edge force, at least 0
    double alpha;         ///< exponent of the tool life, between 0 and 1
    double v1_m_per_min;  ///< m/min, economic speed at an engaged angle of pi, above 0
    /// mm, largest feed per tooth (the cap), above 0. Without it there is no cap.
    std::optional<double> max_feed_per_tooth_mm = {};
    /// mm, least feed per tooth, above 0, at most the cap.
    std::optional<double> min_feed_per_tooth_mm = {};
    std::string name = {};    ///< name of the material
    std::string source = {};  ///< origin of the numbers
};

/// Checks the ranges that CuttingMaterial states.
/// \throws DomainError if a number is outside its range or not finite.
void require_sound(const CuttingMaterial& material);

/// Largest helix angle in rad, in either direction. The accuracy of the loads over a
/// spindle revolution is tested up to this angle. Steeper flutes do not occur on end
/// mills.
inline constexpr double most_helix = 80 * std::numbers::pi / 180;

/// A ball-end mill, as the cutting model needs it. A missing limit does not bind.
struct MillingTool {
    double radius;  ///< mm, r0 of the ball, above 0
    int flutes;     ///< m, at least 1
    /// rad, angle of the flutes against the axis, within `most_helix` in either
    /// direction.
    ///
    /// At the height z above the tip the azimuth of an edge is that of its tip minus z
    /// tan(helix)/r0, in the frame of BallEngagement. This frame is mirrored when milling
    /// down, and the helix is not:
    /// - Milling up, the spindle (clockwise seen from above, M03) rotates towards growing
    ///   azimuths. A positive helix is a right-hand cutter.
    /// - Milling down, the spindle rotates towards falling azimuths. A positive helix is
    ///   a left-hand cutter, and a right-hand cutter has a negative helix.
    ///
    /// The paper does not state the hand of the helix. Means over a revolution do not
    /// depend on the helix. In a full slot, its sign has no effect on the peaks.
    /// Source: docs/methods/ball-end-milling.md, section 4.
    double helix = 0;
    LoadLimits limits = {};  ///< largest loads at any time, above 0
};

/// Checks the ranges that MillingTool states.
/// \throws DomainError if a number is outside its range or not finite.
void require_sound(const MillingTool& tool);

/// The data of `tool` that the cutting model needs. A missing helix becomes 0; a caller
/// for whom the helix matters must check `tool.helix` first.
/// \throws DomainError if the cutter is not a ball-end mill or the number of flutes is
///         missing, or as `require_sound` of a Tool.
MillingTool milling_tool(const Tool& tool);

/// Limits of a milling machine, as the cutting model needs them. A missing limit does not
/// bind.
struct MachineLimits {
    std::optional<double> max_rpm = {};              ///< rpm, of the spindle, above 0
    std::optional<double> max_power_w = {};          ///< W, of the spindle, above 0
    std::optional<double> max_torque_n_m = {};       ///< N m, of the spindle, above 0
    std::optional<double> max_feed_mm_per_min = {};  ///< mm/min, of the drives, above 0
    /// m/s^2, along the path, above 0.
    std::optional<double> acceleration_m_per_s2 = {};

    /// Whether all limits are equal.
    friend bool operator==(const MachineLimits&, const MachineLimits&) = default;
};

/// Checks the limits.
/// \throws DomainError unless every limit is finite and above 0.
void require_sound(const MachineLimits& machine);

}  // namespace endmill
