// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"

namespace endmill {

/// How --limits is written.
inline constexpr const char* rotary_limits_help =
    "limits phi=LO:HI,theta=LO:HI in degrees, rotations of the tool against the part; or "
    "a, b, c: "
    "positions of these axes (default: none)";

/// The limits that `text` spells for a machine. Names are phi and theta, turns of the tool
/// against the part, or the letters of its axes, positions that are mirrored on the part's side
/// of the bed. What is not named stays as `otherwise` has it.
/// \throws DomainError for a name that the machine has not, twice the same axis, what is no
///         LO:HI, and what `expected_rotary_range` objects to.
/// Of a word that is no machine they are checked all the same; phi is then the axis nearer to
/// the part.
RotaryLimits limits_for_machine(const std::string& text,
                                const MachineConfiguration& configuration,
                                const RotaryLimits& otherwise);

/// The same where only the family is known: phi and theta alone; what is not named is not
/// limited.
RotaryLimits limits_for_family(const std::string& text, RotaryFamily family);

}  // namespace endmill
