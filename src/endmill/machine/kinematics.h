// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"

/// \file
/// Forward and inverse kinematics of machines with three to five axes.
///
/// Two layers: `RotaryFrame` and `RotaryAngles` relate tool directions to the two turns
/// phi and theta, in any coordinate frame. `Machine` and `AxisPositions` add offsets,
/// sides and travel, and give the positions of all axes.
/// Source: docs/methods/five-axis-setup.md, section 2.

namespace endmill {

/// The directions of tool and rotary axes while all axes are at zero. They may be given
/// in the machine's own frame, or in the frame of a part that stands on the machine.
struct RotaryFrame {
    RotaryFamily family;  ///< relation of the rotary axes to the tool axis
    Vec3 tool_axis;       ///< unit: C, from the part towards the spindle
    Vec3 r1_axis;         ///< unit; C,A: equal to the tool axis; A,B: perpendicular to it
    Vec3 r2_axis;         ///< unit, perpendicular to the tool axis and, in A,B, to R1
};

/// The two turns that bring the tool into a direction.
struct RotaryAngles {
    double phi;    ///< rad; C,A: tilt, turn of the second axis; A,B: turn of R1
    double theta;  ///< rad; C,A: turn of C; A,B: turn of R2
};

/// The axes of a machine in its own frame. The only rotary axis of a four-axis machine is
/// R1 of the family A,B, with R2 at rest. A three-axis machine has both at rest.
/// \throws DomainError if the configuration is not valid.
RotaryFrame machine_frame(const MachineConfiguration& configuration);

/// The direction of the tool axis after the given turns, a unit vector.
/// Source: [KangSuh, eq. (2)].
Vec3 turned_tool_axis(const RotaryFrame& frame, const RotaryAngles& angles);

/// The turns that bring the tool into a direction. In C,A 0 <= phi <= pi, in A,B |theta|
/// <= pi/2; the other angle lies within (-pi, pi].
///
/// At a singular direction (C,A: both poles; A,B: along R1) the other angle has no
/// effect; it is 0 or a result of rounding. The absolute error is below 1e-14 for phi of
/// C,A and theta of A,B, and below 1e-14 / `distance_from_singular` for the other angle.
/// Source: [KangSuh, eq. (5), (17), (18)], in the closed form of
/// docs/methods/five-axis-setup.md, section 2.
/// \param frame axes at zero.
/// \param direction unit.
RotaryAngles rotary_angles(const RotaryFrame& frame, const Vec3& direction);

/// The second solution: the other two turns that give the same direction, each within
/// [-pi, pi].
RotaryAngles other_rotary_angles(RotaryFamily family, const RotaryAngles& angles);

/// The sine of the angle between a direction and the nearest singular direction, where
/// one turn has no effect (C,A: the poles; A,B: the two directions along R1).
/// \param frame axes at zero.
/// \param direction unit.
double distance_from_singular(const RotaryFrame& frame, const Vec3& direction);

/// The geometry and travel of a machine.
struct Machine {
    MachineConfiguration configuration = {};  ///< axes, and the side of each
    /// mm, from the point where the tool-side axes meet to the spindle nose.
    double pivot = 0;
    Vec3 table_offset{0, 0, 0};  ///< mm, the point where the part-side axes meet
    RotaryLimits rotary = {};    ///< limits as turns of the tool against the part
    LinearLimits linear = {};    ///< travel of X, Y, Z
    /// mm, with all axes at zero: from the line of R1 to that of R2, which are on one side
    /// of the bed. No function uses it yet: positions hold for lines that meet.
    Vec3 axis_offset{0, 0, 0};
    /// rad, limits of the positions of an axis that turns by more than `rotary` states,
    /// from the part to the tool. Nothing: the limits in `rotary` hold.
    std::array<std::optional<RotaryRange>, 2> wide_positions = {};
};

/// Positions of the rotary axes, from the part to the tool, in rad. A position is the
/// right-hand rotation of the body that the axis carries. It is 0 for an axis that the
/// machine lacks.
using RotaryPositions = std::array<double, 2>;

/// Positions of all axes of a machine.
struct AxisPositions {
    RotaryPositions rotary{0, 0};  ///< rad
    Vec3 xyz{0, 0, 0};             ///< mm, position of the tip against the bed
};

/// Inverse kinematics: the positions of all axes when the tip is at a point of the part.
/// \param machine any, also one whose configuration is not valid.
/// \param rotary positions of the rotary axes, rad.
/// \param point mm, of the part, in the machine's directions with all axes at zero.
/// \param tool_length mm, from the spindle nose to the tip.
AxisPositions axis_positions(const Machine& machine, const RotaryPositions& rotary,
                             const Vec3& point, double tool_length);

/// Forward kinematics, the inverse of `axis_positions`: tip and axis of the tool in the
/// frame of the part.
/// \param machine any. \param positions of all axes.
/// \param tool_length mm, from the spindle nose to the tip.
CutterLocation tool_location(const Machine& machine, const AxisPositions& positions,
                             double tool_length);

/// Tests whether all axes can take these positions, the rotary ones to `turn_tolerance`.
/// A rotary axis without limits may be at any number of full rotations, one with wide
/// limits at all positions within them.
/// \pre the configuration is valid.
bool is_within_travel(const Machine& machine, const AxisPositions& positions);

/// One way to turn the tool into a direction.
struct RotarySolution {
    RotaryAngles angles;        ///< turns of the tool against the part
    RotaryPositions positions;  ///< the positions of the axes for these turns
    bool is_within_limits;      ///< the rotary limits hold, to `turn_tolerance`
};

/// All ways to turn the tool into a direction of the part: two solutions with two rotary
/// axes, at most one with fewer.
///
/// Turns are shifted by full rotations into the limits if that is possible, else into
/// [-pi, pi]. If one turn has no effect, it is 0 in the first solution.
/// \param machine valid.
/// \param direction towards the spindle, of any length.
/// \throws DomainError if the configuration is not valid, or the direction is zero or not
///         finite.
std::vector<RotarySolution> rotary_solutions(const Machine& machine,
                                             const Vec3& direction);

}  // namespace endmill
