// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/rotary_angles.h"

namespace endmill {

/// A machine as far as it moves.
struct Machine {
    MachineConfiguration configuration = {};
    double pivot = 0;  ///< mm, from where the tool-side axes meet to the spindle
    Vec3 table_offset{0, 0,
                      0};      ///< mm, where the part-side axes meet: from the zero point
    RotaryLimits rotary = {};  ///< turns of the tool against the part
    LinearLimits linear = {};  ///< of X, Y, Z
};

/// Positions of the rotary axes, from the part to the tool, in rad: each the right-hand turn of
/// what the axis carries. Those of axes that a machine lacks are 0.
using RotaryPositions = std::array<double, 2>;

/// Where all axes of a machine stand.
struct AxisPositions {
    RotaryPositions rotary{0, 0};
    Vec3 xyz{0, 0, 0};  ///< mm, the tip against the bed; whichever slides make it
};

/// Where the axes stand when the tip is at a point of the part.
/// \param rotary where the rotary axes are to stand.
/// \param point of the part, in mm, in the machine's directions, all axes at zero.
/// \param tool_length in mm, from the spindle to the tip.
/// \pre the configuration need not be valid: the turns may be any.
AxisPositions axis_positions(const Machine& machine, const RotaryPositions& rotary,
                             const Vec3& point, double tool_length);

/// The inverse of that: tip and axis of the tool as the part sees them.
CutterLocation tool_location(const Machine& machine, const AxisPositions& positions,
                             double tool_length);

/// Whether all axes can stand there, rotary ones to `turn_tolerance`. Positions of an axis that
/// goes all the way round count but for whole turns.
/// \pre the configuration is valid.
bool is_within_travel(const Machine& machine, const AxisPositions& positions);

/// Where the rotary axes of a machine can stand to give a direction.
struct RotarySolution {
    RotaryAngles angles;        ///< turns of the tool against the part
    RotaryPositions positions;  ///< the same of each axis
    bool is_within_limits;      ///< of the rotary axes, to `turn_tolerance`
};

/// The positions that turn the tool into a direction of the part: two with two rotary axes,
/// one or none with one or none. They lie within the limits wherever whole turns can bring
/// them there, else within half a turn. Where one turn does not matter it is 0 in the first
/// solution.
/// \param direction towards the spindle, of any length.
/// \throws DomainError unless the configuration is valid and the direction finite and not zero.
std::vector<RotarySolution> rotary_solutions(const Machine& machine,
                                             const Vec3& direction);

}  // namespace endmill
