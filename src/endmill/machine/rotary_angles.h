// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/machine/configuration.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// The lines of tool and rotary axes while all axes stand at zero, in one frame: the machine's
/// own, or that of a part as it is set up.
struct RotaryFrame {
    RotaryFamily family;
    Vec3 tool_axis;  ///< unit: C, from the part towards the spindle
    Vec3 r1_axis;    ///< unit; C,A: the tool axis; A,B: across it
    Vec3 r2_axis;    ///< unit; across tool axis and, in A,B, R1
};

/// The turns that bring the tool into a direction.
struct RotaryAngles {
    double phi;    ///< rad; C,A: the tilt, of the second axis; A,B: of R1
    double theta;  ///< rad; C,A: of C; A,B: of R2
};

/// The machine's own axes. A single rotary axis A or B is R1 of A,B, with R2 at rest; with none
/// both are at rest.
/// \throws DomainError unless the configuration is valid.
RotaryFrame machine_frame(const MachineConfiguration& configuration);

/// Where the tool axis points after those turns; unit. Source: [KangSuh, eq. (2)].
Vec3 turned_tool_axis(const RotaryFrame& frame, const RotaryAngles& angles);

/// The turns that the direction asks for: in C,A 0 <= phi <= pi, in A,B |theta| <= pi/2, the
/// other within (-pi, pi]. Where it does not matter (C,A: at either pole; A,B: along R1) the
/// other is 0 or what rounding makes of it. Absolute error below 1e-14, of the other divided by
/// the sine of the distance from there.
/// Source: [KangSuh, eq. (5), (17), (18)] in closed form.
/// \pre `direction` is unit.
RotaryAngles rotary_angles(const RotaryFrame& frame, const Vec3& direction);

/// The other turns that give the same direction, each within [-pi, pi].
RotaryAngles other_rotary_angles(RotaryFamily family, const RotaryAngles& angles);

/// How far the direction is from those at which one turn does not matter, as a sine: C,A the
/// poles, A,B the two directions along R1.
/// \pre `direction` is unit.
double distance_from_singular(const RotaryFrame& frame, const Vec3& direction);

}  // namespace endmill
