// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// The G-code program `text` with the feeds and spindle speeds of `path`. Only F and S
/// words change; lines, comments, arcs and all other words stay as they are.
///
/// F and S are replaced on lines that move, or added if the current value would be wrong.
/// An S on a line before a motion becomes the S of that motion. F is in the unit and feed
/// mode of the program, including inches and G93.
///
/// An arc keeps its line if its chords differ by at most 0.1 % in feed and in speed. The
/// line then gets the smallest speed and the smallest feed per revolution of its chords,
/// so that no limit is exceeded. Otherwise the arc is split into several arcs on the same
/// circle, each below a full turn, with ends written to 1e-6 of the unit. An arc on a
/// line with M codes is never split, because an M code may stop the program there.
///
/// A canned cycle keeps its line too, with the smallest feed of its moves. Under G96 the
/// words S are cutting speeds and stay as they are.
///
/// \param text the program.
/// \param file name of the file for messages.
/// \param options the options with which the path was read.
/// \param path the path that `parse_gcode` returns for the same text and options, with
///        other conditions. Moves without a feed keep the feed of their line.
/// \throws FormatError, LimitError as `parse_gcode`.
/// \throws DomainError if the path has another number of points, or for a feed or speed
///         that is not above 0 after rounding to four decimals (six for feeds in inches
///         and under G93).
/// Source: docs/methods/ball-end-milling.md, section 13; [KramerProctorMessina,
/// section 3].
std::string fed_gcode(std::string_view text, const std::string& file,
                      const GcodeReadOptions& options, const ToolPath& path);

/// The same in pieces, for a program of millions of lines.
/// \param sink receives the pieces in order; after an exception they are incomplete.
/// \throws as `fed_gcode`, and whatever `sink` throws.
void write_fed_gcode(std::string_view text, const std::string& file,
                     const GcodeReadOptions& options, const ToolPath& path,
                     const std::function<void(std::string_view piece)>& sink);

}  // namespace endmill
