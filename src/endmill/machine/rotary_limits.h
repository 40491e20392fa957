// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace endmill {

/// The two shapes that the tool directions of five-axis machines make on the sphere.
/// Source: [KangSuh, section 3].
enum class RotaryFamily {
    CA,  ///< the first rotary axis is C: two opposite sectors about the pole
    AB   ///< A and B, either first: a rectangle between meridians and parallels
};

/// Turns of one rotary axis, of the tool against the part, right-hand rule about +X, +Y or +Z.
struct RotaryRange {
    double from = -std::numbers::pi;  ///< rad, at most 0
    double to = std::numbers::pi;     ///< rad, at least 0; at most 2 pi beyond `from`

    /// Whether both say the same.
    friend bool operator==(const RotaryRange&, const RotaryRange&) = default;
};

/// How far the rotary axes go. Not given is not limited.
struct RotaryLimits {
    RotaryRange phi = {};    ///< C,A: the tilt, second letter; A,B: R1, first letter
    RotaryRange theta = {};  ///< C,A: C, first letter; A,B: R2, second letter

    /// Whether both say the same.
    friend bool operator==(const RotaryLimits&, const RotaryLimits&) = default;
};

}  // namespace endmill
