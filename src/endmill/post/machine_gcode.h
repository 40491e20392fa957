// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "endmill/path/tool_path.h"
#include "endmill/post/gcode_writer.h"
#include "endmill/post/machine_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// Format of a program with rotary axes, beside that of GcodeOptions.
struct MachineGcodeFormat {
    int angle_decimals = 5;  ///< digits after the point of rotary words, 0 to 9
    /// mm, from 0: how far the control may round corners of X, Y and Z (`G64 P`). None:
    /// exact path, `G61`, because the control would round the rotary axes too.
    std::optional<double> blend = {};
};

/// A program for a machine with rotary axes.
struct WrittenMachineProgram {
    WrittenProgram program;  ///< its text, lengths and times of the tip in the part
    TipBox xyz_range;        ///< mm, X, Y and Z of the program
    std::array<MinMax, 2> rotary_range;  ///< rad, positions of R1 and R2
    double rounding_tip_mm = 0;  ///< mm, largest distance of a tip by rounding all words
    double rounding_axis = 0;    ///< rad, largest angle of an axis by rounding
};

/// The motions of a machine as a program of RS-274 with rotary words A, B and C.
///
/// Rotary words are rounded first. X, Y and Z are those of the rounded angles: positions of
/// the axes for Interpolation::Joint, tips in the clamped part for Interpolation::Tcp.
/// Moves that turn an axis are written under inverse time, G93, with F = 1/min rounded down
/// to six significant digits; moves between rapids with resting rotary axes under G94. A
/// block whose words do not change is left out, and its time is added to the next one.
///
/// The tool rises to the safe height, the rotary axes turn, and X and Y move to a place
/// from which the tool reaches the first point along its axis. After the last point it
/// leaves along its axis. Rapids that turn an axis need a control that moves all axes of G0
/// evenly.
///
/// \param made motions with one tool.
/// \param options as for `gcode`; without a safe height it is 5 mm above all positions and,
///        on a machine that turns the part, above the sphere in which the path turns.
/// \throws DomainError as `gcode`, and for arcs, slopes, an approach distance or several
///         tools, which these programs do not have.
/// \throws GeometryError for a move that takes so long that F rounds to 0.
/// Source: docs/methods/five-axis-paths.md, sections 6 and 7.
WrittenMachineProgram machine_gcode(const MachinePath& made, const GcodeOptions& options,
                                    const MachineGcodeFormat& format = {});

}  // namespace endmill
