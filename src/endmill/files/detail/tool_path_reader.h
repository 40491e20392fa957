// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/files/read_file.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// Whether the first line of `text` is meant as the header of a CSV tool path: it names a
/// column of tips.
bool is_tool_path_csv(std::string_view text);

/// Parses a CSV tool path, as `tool_path_csv` writes it, to the same doubles.
///
/// The columns tip_x_mm, tip_y_mm and tip_z_mm are required; the others are optional, in
/// any order. Remarks of the result state each assumption: without the column move every
/// move is a cut; without axis the axis is +z; without all of u, v, contact and normal
/// only the normal is kept; the column limit is ignored; without a machine the columns x_mm
/// to r2_deg are ignored. Without the column point, points are numbered through the file.
/// \param file name of the file for messages.
/// \param machine that interpolates the path, without positions: the columns x_mm to r2_deg
///        are then required.
/// \throws FormatError E_CSV with the line for a column that is unknown, lacks its unit
///         or occurs twice; for a vector with a missing column or, in a row, a missing
///         component; for a row with another number of cells than the header, an unknown
///         tip, a cell that is not a finite number, an unknown move, an axis or normal
///         that is not a unit vector (`unit_axis`), a feed or speed that is not positive,
///         a negative tool number, a file without rows, and positions of a machine that
///         are missing or more than 1e-6 off the pose. E_RANGE for a coordinate
///         beyond the limit.
/// \throws LimitError if the path needs more memory than the limit.
Program parse_tool_path(std::string_view text, const std::string& file,
                        const ReadLimits& limits = {},
                        const std::optional<MachineMotion>& machine = {});

/// Reads the file and parses it as `parse_tool_path` does.
/// \throws FormatError, LimitError also as `read_file`.
Program read_tool_path(const std::filesystem::path& path, const ReadLimits& limits = {});

}  // namespace endmill
