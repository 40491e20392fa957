// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Readers of G-code programs: of RS-274 directly, and of the canonical output that
/// LinuxCNC's interpreter prints for a program with parameters, subprograms or cycles.
///
/// Implemented in `gcode_reader.cpp`, `canonical_reader.cpp` (canonical output) and
/// `interpreter_text.cpp` (programs for the interpreter).

#include <string>
#include <string_view>

#include "endmill/post/program.h"

namespace endmill {

/// The path that a three-axis program of RS-274 (G-code) describes. A code or word that
/// would move the tool and is not supported is an error. Codes that move nothing are
/// skipped; one remark counts them, unless all stand in almost every program.
///
/// Words, modes and the order of execution within a block follow LinuxCNC. Lengths become
/// mm and feeds mm/min.
/// - *Moves*: G0 is a rapid. G1 straight down is a plunge, straight up a retract, and
///   otherwise a cut. Arcs are cuts along chords within the arc tolerance.
/// - *Arcs*: the radii at the two ends may differ by the larger of 0.01 mm and 0.1 %, and
///   a radius R may be too small by as much.
/// - *Start*: the position is unknown until the program has given each axis an absolute
///   position. Earlier moves are left out; a remark reports them if they may have cut.
/// - *Canned cycles* are the moves that LinuxCNC makes (`detail/canned_cycle.h`). The
///   reversal of the spindle that leaves a tapped hole is no M4 of the program.
/// - *Reference moves*: G28, G30 and G53 go to positions that only the machine knows. The
///   path rises straight to 5 mm above all points before, and stays there until the axes
///   that moved have an absolute position again; a remark counts these moves. A cut before
///   that is an error. A reference move sideways at or below the height of an earlier cut
///   is an error too.
/// - *Feed*: F in the block of a G20 or G21 is in the new unit. G93 and G94 discard the F
///   before them.
/// - *M codes*: M2 and M30 end the program, M3 to M5 control the spindle, M6 changes the
///   tool, unsupported ones are refused, and all others have no effect.
/// - *%*: a % after words ends the program; no blocks may stand on both sides of the
///   first %. A program number, "O1001" or ":1001", may stand before the first block.
///
/// \param text the program.
/// \param file name of the file for messages.
/// \param options arc tolerance, programmed point and limits.
/// \throws FormatError with file and line: E_GCODE for what is not supported, and for a
///         program without motion or without a position of every axis; E_RANGE for
///         numbers that are too large, E_LIMIT for a line over 1 MiB, E_EMPTY for a file
///         of white space.
/// \throws LimitError if the path would have more points than the options allow.
/// \throws DomainError unless the options are sound.
/// Source: docs/methods/removal.md, section 5; [KramerProctorMessina, section 3].
Program parse_gcode(std::string_view text, const std::string& file,
                    const GcodeReadOptions& options = {});

/// Whether `text` is canonical output: its first line that is not empty has the form
/// "12 N..... NAME(" or "12 N30 NAME(".
bool is_canonical(std::string_view text);

/// The path in the canonical output of LinuxCNC's interpreter, `rs274 -g`, in which
/// parameters, subprograms and cycles are expanded. Moves, passes, tools and arcs are
/// those of `parse_gcode`. Known commands that cannot move the tool are ignored; unknown
/// commands are errors. The output states coordinates without the offsets in force; the
/// path is in the coordinates of its first move, and moves under other offsets are
/// converted. Rapids to positions of the machine are those of `parse_gcode` too, where the
/// options state how the output shows them. Coordinates have four decimals, so `position_error_mm` is half of the last
/// one.
///
/// \param text the output.
/// \param file name of the file for messages.
/// \param options as for `parse_gcode`. `block_delete` has no effect, because the
///        interpreter has applied it already.
/// \throws FormatError with file and line: E_CANONICAL for a line of another form,
///         unsupported motion, rotary axes, an arc across turned coordinates, a move
///         without a feed, or no motion at all; E_RANGE, E_LIMIT and E_EMPTY as `parse_gcode`.
/// \throws LimitError, DomainError as `parse_gcode`.
/// Source: docs/methods/removal.md, sections 5 and 6.
Program parse_canonical(std::string_view text, const std::string& file,
                        const GcodeReadOptions& options = {});

/// Magnitude in mm beyond which a coordinate in the output of an interpreter that has
/// read `interpreter_parameters` is a position of the machine.
inline constexpr double least_machine_position_mm = 1e8;

/// The parameters (a file .var) with which LinuxCNC's interpreter takes the reference
/// points of G28 and G30 far outside of every machine, so that its output shows them.
std::string interpreter_parameters();

/// `program` with the targets of G53 replaced by positions as far away as those of
/// `interpreter_parameters`. All lines keep their numbers.
/// \param program a program without comments.
/// \param file name of the file for messages.
/// \throws FormatError E_GCODE with the line, where a block with G53 has parameters,
///         expressions or an O-word.
std::string with_far_machine_positions(std::string_view program, const std::string& file);

}  // namespace endmill
