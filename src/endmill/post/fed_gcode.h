// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "endmill/path/tool_path.h"
#include "endmill/post/gcode_reader.h"

namespace endmill {

/// The G-code program `text` with the feeds and spindle speeds of `path`: lines, comments, arcs
/// and everything else stay as they stand. Only these words change: F and S of lines that move
/// are set, or added where what is in force would be wrong; an S before motion becomes that of
/// the motion. F is in the program's unit and feed mode, G93 and inches too.
///
/// An arc keeps its line while its chords differ by at most a thousandth in feed and in speed: it
/// has the least speed and the least feed a turn of them, so that no limit is passed. Otherwise
/// it becomes several arcs on the same circle, of at most a turn each, written to 1e-6 of the
/// unit. One in a line with M codes, which may stop the program, stays one.
///
/// \param path as `parse_gcode` gives for the same text and options, but for its conditions.
///        Moves without a feed keep what their line says.
/// \param file the name for messages.
/// \throws FormatError, LimitError as `parse_gcode`.
/// \throws DomainError if the path has another number of points, or a feed or speed that is
///         not above 0 once rounded to four decimals (feeds in inches or 1/min: six).
/// Source: spec of ball-end milling, section 13; [KramerProctorMessina] for the language.
std::string fed_gcode(std::string_view text, const std::string& file,
                      const GcodeReadOptions& options, const ToolPath& path);

}  // namespace endmill
