// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"

/// \file
/// Forward and inverse kinematics of machines with three to five axes.
///
/// Three layers: `RotaryFrame` and `RotaryAngles` relate tool directions to the two turns
/// phi and theta, in any coordinate frame. `Machine` and `AxisPositions` add offsets,
/// sides and travel, and give the positions of all axes. `PartOnMachine` adds the tool and
/// the part, and relates poses of the tool in the part to positions.
/// Source: docs/methods/five-axis-setup.md, section 2; docs/methods/five-axis-paths.md,
/// section 1.

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

/// Positions of the rotary axes, from the part to the tool, in rad. A position is the
/// right-hand rotation of the body that the axis carries. It is 0 for an axis that the
/// machine lacks.
using RotaryPositions = std::array<double, 2>;

/// Largest speeds of the axes. A missing speed is not limited.
struct AxisRates {
    std::array<std::optional<double>, 3> linear_mm_per_min = {};   ///< of X, Y, Z alone
    std::array<std::optional<double>, 2> rotary_rad_per_min = {};  ///< of R1 and R2
    std::optional<double> feed_mm_per_min = {};  ///< of X, Y and Z together

    /// Compares all speeds exactly.
    friend bool operator==(const AxisRates&, const AxisRates&) = default;
};

/// The geometry and travel of a machine.
struct Machine {
    MachineConfiguration configuration = {};  ///< axes, and the side of each
    /// mm, from the point where the tool-side axes meet to the spindle nose.
    double pivot = 0;
    Vec3 table_offset{0, 0, 0};  ///< mm, the point where the part-side axes meet
    RotaryLimits rotary = {};    ///< limits as turns of the tool against the part
    LinearLimits linear = {};    ///< travel of X, Y, Z
    /// mm, with all axes at zero: from the line of R1 to that of R2, which are on one side
    /// of the bed; else zero. On the part's side `table_offset` is on the line of R1, on
    /// the tool's side `pivot` counts from the line of R2.
    Vec3 axis_offset{0, 0, 0};
    /// rad, limits of the positions of an axis of at least one full rotation, from the part
    /// to the tool. Nothing: the limits in `rotary` hold, and a range of a full rotation
    /// there does not limit the axis.
    std::array<std::optional<RotaryRange>, 2> wide_positions = {};
    /// The word of a rotary axis in a program is its position times this sign: 1 or -1.
    RotaryPositions word_signs{1, 1};
    AxisRates rates = {};  ///< largest speeds
};

/// The positions that a rotary axis can take.
/// \param machine valid. \param axis index from the part to the tool. \pre the machine has
///        this axis.
/// \return rad; both ends are infinite for an axis that is not limited.
RotaryRange position_range(const Machine& machine, std::size_t axis);

/// Positions of all axes of a machine.
struct AxisPositions {
    RotaryPositions rotary{0, 0};  ///< rad
    /// mm, position of the tool against the bed: that of the tip if all rotary axes of the
    /// tool's side are at zero.
    Vec3 xyz{0, 0, 0};

    /// Compares all positions exactly.
    friend bool operator==(const AxisPositions&, const AxisPositions&) = default;
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

/// A machine with a tool and a clamped part.
///
/// A point p of the part is at p' = M p + s in the directions of the machine, with all
/// rotary axes at zero.
struct PartOnMachine {
    Machine machine = {};    ///< kinematics and travel
    double tool_length = 0;  ///< mm, from the spindle nose to the tip
    /// M, the rotation of the part. Its rows are X, Y and Z of the machine in the part.
    Eigen::Matrix3d part_to_machine = Eigen::Matrix3d::Identity();
    Vec3 clamp{0, 0, 0};  ///< s, mm: where the origin of the part is clamped
};

/// p' = M p + s, and for directions M v.
Vec3 clamped_point(const PartOnMachine& setup, const Vec3& point);

/// The positions of all axes when the tip is at a point of the part.
/// \param rotary positions of the rotary axes, rad.
/// \param tip mm, in the frame of the part.
/// Error below 1e-14 times the largest length involved.
AxisPositions axis_positions(const PartOnMachine& setup, const RotaryPositions& rotary,
                             const Vec3& tip);

/// The pose of the tool in the frame of the part.
/// Error of the tip below 1e-14 times the largest length involved, of the axis below 1e-14.
CutterLocation tool_location(const PartOnMachine& setup, const AxisPositions& positions);

/// The tip against the bed, in the directions of the machine: `positions.xyz`, moved by the
/// turns of the tool.
Vec3 tip_over_bed(const PartOnMachine& setup, const AxisPositions& positions);

/// All ways to turn the tool into a direction of the part, as `rotary_solutions` of a
/// machine. \param direction in the frame of the part.
std::vector<RotarySolution> rotary_solutions(const PartOnMachine& setup,
                                             const Vec3& direction);

/// The tip in the part while all axes move, and its derivatives with respect to the
/// parameter of the motion.
struct TipMotion {
    Vec3 tip;           ///< mm
    Vec3 velocity;      ///< mm
    Vec3 acceleration;  ///< mm
};

/// The motion of the tip at one position of axes that move evenly.
/// \param at the positions. \param rates their derivatives, rad and mm; the second
///        derivatives are zero.
/// Source: docs/methods/five-axis-paths.md, section 3.
TipMotion tip_motion(const PartOnMachine& setup, const AxisPositions& at,
                     const AxisPositions& rates);

/// How the tool moves from one pose to the next.
/// Source: docs/methods/five-axis-paths.md, section 2.
enum class Interpolation {
    Linear,  ///< in the part: the tip on a straight line, the axis on a great arc, evenly
    Tcp,     ///< the tip on a straight line in the part, rotary positions evenly
    Joint,   ///< X, Y, Z and rotary positions of the machine evenly
};

/// The name of an interpolation in files: "linear", "tcp" or "joint".
std::string_view interpolation_name(Interpolation interpolation);

/// The interpolation with this name.
/// \return nothing if there is none.
std::optional<Interpolation> interpolation_from_name(std::string_view name);

/// The axis at parameter u, from 0 to 1, of the great arc between two unit vectors, evenly:
/// [sin((1 - u) a) from + sin(u a) to] / sin a with the angle a between them.
/// Error below 1e-14 / sin a.
/// \pre the vectors are not opposite.
Vec3 axis_on_arc(const Vec3& from, const Vec3& to, double u);

/// The angle between two unit vectors in rad, accurate at all angles.
double angle_between(const Vec3& first, const Vec3& second);

}  // namespace endmill
