// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/post/detail/arc.h"
#include "endmill/post/detail/gcode_modes.h"
#include "endmill/post/detail/text_lines.h"
#include "endmill/post/program.h"

namespace endmill {

/// How a machine program is read, and what is accepted before the reader gives up.
struct GcodeReadOptions {
    double arc_tolerance_mm = 0.001;  ///< largest distance of an arc's chords from it
    bool block_delete = false;        ///< whether blocks that begin with / are left out
    double programmed_point_height_mm = 0;  ///< above the tip: the corner radius, if the
                                            ///< centre is programmed
    double max_extent_mm = 1e6;             ///< largest magnitude of a coordinate
    std::size_t most_points = 10'000'000;   ///< of the path; see `points_within`
};

/// How many points a program may have that is read in `memory_gib` GiB.
/// \pre memory_gib >= 0
std::size_t points_within(double memory_gib);

/// \throws DomainError unless the tolerance and the extent are positive and the height of
///         the programmed point is at least 0, all of them finite.
void check_options(const GcodeReadOptions& options);

/// \throws FormatError E_RANGE at the line where `lines` stands if |coordinate| is beyond
///         the largest extent.
void check_extent(double coordinate_mm, const GcodeReadOptions& options,
                  const TextLines& lines);

/// The path that a three-axis program of RS-274 (G-code) describes. What the reader does
/// not follow is an error, never skipped.
///
/// Words, modes and their order in a block are those of LinuxCNC; lengths become mm, feeds
/// mm/min. Moves: G0 is a rapid, G1 as `ProgramBuilder` has it, arcs are cuts in chords
/// (`ArcChords`). Radii of an arc's ends may differ by the larger of 0.01 mm and 0.1 %, and
/// a radius R may be too small by so much. Until each axis has had an absolute position,
/// the place is unknown: such moves are left out, and said.
///
/// F in the block of a G20 or G21 is in the new unit; G93 and G94 forget the F before them.
/// M codes but for M2, M30, M3 to M6 and those that are refused do nothing. The program
/// ends with M2, M30 or the second `%`. The first `%` stands before all words.
///
/// \param file the name for messages.
/// \throws FormatError with the line: E_GCODE for what is refused, E_RANGE for numbers
///         that are too large, E_LIMIT for a line over 1 MiB; E_EMPTY for a file of white
///         space.
/// \throws LimitError if the path would have more points than the options allow.
/// \throws DomainError as `check_options`.
/// Source: spec of the removal, section 5; [KramerProctorMessina].
Program parse_gcode(std::string_view text, const std::string& file,
                    const GcodeReadOptions& options = {});

/// A line of a program that moves the tool.
struct GcodeMove {
    std::size_t line;             ///< from 1
    std::size_t first;            ///< of the path's points that it made
    std::size_t end;              ///< behind the last of them
    GcodeModes modes;             ///< in force, with the line's own codes
    std::optional<Arc> arc = {};  ///< if the line goes along one
};

/// The lines that make the points of the path, in order, none without a point.
/// \throws as `parse_gcode`.
std::vector<GcodeMove> gcode_moves(std::string_view text, const std::string& file,
                                   const GcodeReadOptions& options = {});

}  // namespace endmill
