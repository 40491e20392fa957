// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "cli/command.h"
#include "endmill/machine/kinematics.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// The totals of a path in a summary: cut_mm, plunge_mm, link_mm, rapid_mm, time_min,
/// tools, min_mm, max_mm.
void add_path_totals(Json& summary, const PathTotals& totals);

/// One line of a report on these totals: lengths and time.
std::string path_totals_text(const Json& summary);

/// The box of all tips: "x 0 to 10, y -5 to 5, z 0 to 20.5 mm".
std::string extent_text(const Json& summary);

/// Numbers the points of a path from 0 in its order, as all files and messages do.
void number_points(ToolPath& path);

/// Adds what identifies the path file beside a summary: toolpath_points and
/// toolpath_sha256. A summary beside another file is not used, see `path_summary_of`.
/// \param sha256 `content_sha256` of the file.
void identify_path(Json& summary, std::size_t points, const std::string& sha256);

/// Adds source_sha256, the SHA-256 of the path from which the path of this summary was made.
/// \throws FormatError, LimitError as `read_file`.
void add_source_path(Json& summary, const std::string& file, const ReadLimits& limits);

/// Adds what a path or program needs of its machine to be read: interpolation and machine, as
/// `read_path_summary` reads them.
void add_machine_motion(Json& summary, const MachineMotion& motion);

}  // namespace endmill
