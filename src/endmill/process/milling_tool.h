// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>

#include "endmill/cutter/tool.h"

namespace endmill {

/// Steeper flutes are none of an end mill, and their loads over a turn are not promised.
inline constexpr double most_helix = 80 * std::numbers::pi / 180;  ///< rad, either way

/// A ball-end mill as the cut sees it. A limit that is not given does not bind.
struct MillingTool {
    double radius;  ///< r0 of the ball, mm, above 0
    int flutes;     ///< m, from 1
    /// Of the flutes against the axis, rad, within `most_helix` either way. In the frame of
    /// BallEngagement edges trail by it, also when that frame is mirrored: see HelicalEdge.
    double helix = 0;
    std::optional<double> cutting_force_n =
        {};  ///< most across the axis at any time, N, above 0
    std::optional<double> thrust_n = {};    ///< most along the axis, N, above 0
    std::optional<double> torque_n_m = {};  ///< N m, above 0
};

/// \throws DomainError unless every number is finite and as said above.
void require_sound(const MillingTool& tool);

/// What the cut sees of `tool`. A helix that it does not tell is 0: where the flutes' course
/// matters, ask `tool.helix` first.
/// \throws DomainError if it is no ball-end mill, or does not tell its flutes; or as
///         `require_sound` of a Tool.
MillingTool milling_tool(const Tool& tool);

}  // namespace endmill
