// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "endmill/post/gcode_reader.h"
#include "endmill/post/program.h"

namespace endmill {

/// Whether `text` is what `rs274 -g` prints: its first line that is not empty reads
/// "12 N..... NAME(" or "12 N30 NAME(".
bool is_canonical(std::string_view text);

/// The path in the canonical output of LinuxCNC's interpreter, `rs274 -g`, with parameters,
/// subprograms and cycles expanded. Moves, passes, tools and radii as `parse_gcode`; lines
/// that cannot move the tool are passed over if they are known, and errors otherwise.
/// Coordinates have four decimals: `position_error_mm` is half the last one.
///
/// \param options its `block_delete` does not matter: the interpreter has seen to it.
/// \throws FormatError with the line: E_CANONICAL for what is no such line, motion that is
///         not followed, rotary axes, a move under an offset or a rotation, or without a
///         feed; E_RANGE, E_LIMIT and E_EMPTY as `parse_gcode`.
/// \throws LimitError, DomainError as `parse_gcode`.
/// Source: spec of the removal, sections 5 and 6.
Program parse_canonical(std::string_view text, const std::string& file,
                        const GcodeReadOptions& options = {});

}  // namespace endmill
