// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>
#include <string>

#include "endmill/cutter/tool.h"

namespace endmill {

/// What a work material asks of the cutter: forces by chip and edge, and the speed that
/// it is cut at. Tangential force of an element of the edge of depth dz under a chip of
/// thickness t: K (t + h*) dz; radial K (r1 t + r2 h*) dz; axial K (r3 t + r4 h*) dz.
/// Source: [ParkMaeng, eq. (1), (4)] as corrected in spec of ball-end milling, section 2;
/// in the notation of K_tc, K_te, ...: K = K_tc, h* = K_te/K_tc, r1 = K_rc/K_tc,
/// r2 = K_re/K_te, r3 = K_ac/K_tc, r4 = K_ae/K_te.
struct CuttingMaterial {
    double specific_resistance_n_per_mm2;  ///< K, above 0
    double edge_thickness_mm;              ///< h*, from 0
    double r1;            ///< radial over tangential force of the chip, from 0
    double r2;            ///< radial over tangential force of the edge, from 0
    double r3;            ///< axial over tangential force of the chip, from 0
    double r4;            ///< axial over tangential force of the edge, from 0
    double alpha;         ///< exponent of the tool life, between 0 and 1
    double v1_m_per_min;  ///< economic speed of a full half turn of engagement, above 0
    std::optional<double> max_feed_per_tooth_mm = {};  ///< the cap, above 0
    std::optional<double> min_feed_per_tooth_mm = {};  ///< above 0, at most the cap
    std::string name = {};
    std::string source = {};  ///< origin of the numbers
};

/// \throws DomainError unless every number is finite and as said above.
void require_sound(const CuttingMaterial& material);

/// Steeper flutes are none of an end mill, and their loads over a turn are not promised.
inline constexpr double most_helix = 80 * std::numbers::pi / 180;  ///< rad, either way

/// A ball-end mill as the cut sees it. A limit that is not given does not bind.
struct MillingTool {
    double radius;  ///< r0 of the ball, mm, above 0
    int flutes;     ///< m, from 1
    /// Of the flutes against the axis, rad, within `most_helix` either way. In the frame
    /// of BallEngagement edges trail by it, also when that frame is mirrored: see
    /// HelicalEdge.
    double helix = 0;
    std::optional<double> cutting_force_n =
        {};  ///< most across the axis at any time, N, above 0
    std::optional<double> thrust_n = {};    ///< most along the axis, N, above 0
    std::optional<double> torque_n_m = {};  ///< N m, above 0
};

/// \throws DomainError unless every number is finite and as said above.
void require_sound(const MillingTool& tool);

/// What the cut sees of `tool`. A helix that it does not tell is 0: where the flutes'
/// course matters, ask `tool.helix` first.
/// \throws DomainError if it is no ball-end mill, or does not tell its flutes; or as
///         `require_sound` of a Tool.
MillingTool milling_tool(const Tool& tool);

/// What a milling machine bears and reaches, as the cut sees it. A limit that is not
/// given does not bind.
struct MachineLimits {
    std::optional<double> max_rpm = {};                ///< of the spindle, above 0
    std::optional<double> max_power_w = {};            ///< of the spindle, above 0
    std::optional<double> max_torque_n_m = {};         ///< of the spindle, above 0
    std::optional<double> max_feed_mm_per_min = {};    ///< of the feed drives, above 0
    std::optional<double> acceleration_m_per_s2 = {};  ///< along the path, above 0

    /// Whether both say the same.
    friend bool operator==(const MachineLimits&, const MachineLimits&) = default;
};

/// \throws DomainError unless every number is finite and above 0.
void require_sound(const MachineLimits& machine);

}  // namespace endmill
