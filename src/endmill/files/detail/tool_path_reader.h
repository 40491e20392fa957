// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/post/program.h"

namespace endmill {

/// Whether the first line of `text` names a column of tips: a tool path, or meant as one.
bool is_tool_path_csv(std::string_view text);

/// Reads a tool path as `tool_path_csv` writes it, to the same doubles. It needs the
/// columns tip_x_mm, tip_y_mm and tip_z_mm; all others may be missing, and stand in any
/// order. Without move every move is a cut, without axis it is +z, and remarks say so;
/// likewise that of contacts without all of u, v, contact and normal no more than the normal
/// is kept, and that the column limit is left out. Without point, points count through the file.
/// \param file the name for messages.
/// \throws FormatError E_CSV with the line for a column that is unknown, without its unit
///         or named twice, a vector that lacks a column or, in a row, a component; for a
///         row with another number of cells than the header; a tip that is not known;
///         what is no number where one belongs, NaN and infinity included; an unknown move;
///         an axis or normal whose length is not 1 (`unit_axis`); a feed or speed that is
///         not above 0; a negative tool; if there is no row. E_RANGE for a length beyond
///         the limit.
/// \throws LimitError if the path needs more memory than the limit.
Program parse_tool_path(std::string_view text, const std::string& file,
                        const ReadLimits& limits = {});

/// The same from a file. \throws FormatError and LimitError also as `read_file`.
Program read_tool_path(const std::filesystem::path& path, const ReadLimits& limits = {});

/// The line, from 1, of row number `row`, from 0, of a table that `parse_tool_path` reads.
/// \pre It has that row.
std::size_t line_of_row(std::string_view text, std::size_t row);

}  // namespace endmill
