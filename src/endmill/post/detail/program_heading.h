// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "endmill/post/detail/block_writer.h"
#include "endmill/post/gcode_writer.h"

namespace endmill {

/// Digits after the decimal point of coordinates: those of the options or the control.
int decimals_of(const GcodeOptions& options);

/// The format of blocks for a control.
BlockFormat block_format(const GcodeOptions& options);

/// The block that waits, G4 P.
std::string dwell(const GcodeOptions& options);

/// The word that turns the coolant on; nothing for no coolant.
/// \throws DomainError if the control has no word for it.
std::optional<std::string> coolant_word(const GcodeOptions& options);

/// `G64 P`, which lets the control round corners by `blend_mm`, with enough decimals to be
/// within 1 % of it; `G61` for 0 and for less than nine decimals can state.
std::string blending_block(const GcodeOptions& options, double blend_mm);

/// Adds the start of a program: %, number, comment, modes and path control.
/// \param path_control its block; may be empty.
/// \param coordinates what the comment states of the coordinates.
void write_start(BlockWriter& blocks, const GcodeOptions& options,
                 const std::string& path_control, std::string_view coordinates = "tips");

/// Adds the end of a program: coolant off, the last blocks of the control and %.
void write_end(BlockWriter& blocks, const GcodeOptions& options);

}  // namespace endmill
