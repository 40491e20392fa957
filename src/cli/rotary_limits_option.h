// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// Help text of --limits.
inline constexpr const char* rotary_limits_help =
    "phi=LO:HI,theta=LO:HI: limits of the tool's rotations against the part, in degrees; "
    "or a=LO:HI, b=..., c=...: limits of the axis positions (default: none)";

/// The machine with the limits of the text. The names are phi and theta for rotations of
/// the tool against the part, or the letters of the axes for axis positions. The positions
/// of an axis on the part's side of the bed are mirrored. Axes that are not named keep
/// their limits. If the configuration is not valid, the limits are checked as well, and
/// phi is the axis nearer to the part.
/// \throws DomainError for a name that the machine does not have, an axis that is named
///         twice, a text that is not LO:HI, and a range that `expected_rotary_range`
///         refuses.
Machine limited_machine(Machine machine, const std::string& text);

/// Parses the limits of a family, whose names are phi and theta only. Axes that are not
/// named have no limits.
RotaryLimits limits_for_family(const std::string& text, RotaryFamily family);

}  // namespace endmill
