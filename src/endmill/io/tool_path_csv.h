// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/path/tool_path.h"

namespace endmill {

/// The tool path as a CSV file of the columns pass, point, move, tip_x_mm … tip_z_mm,
/// axis_x … axis_z, tool (if any point has one), patch (if the path is over several), u, v,
/// contact_x_mm … contact_z_mm, normal_x … normal_z, feed_mm_per_min and spindle_rpm (each
/// if any point has one), a line a point. Numbers have the shortest text that reads back
/// to the same double; what a point does not have is an empty cell. The same bytes with
/// any number of threads.
/// \throws DomainError if a number is not finite, or there are conditions for some points
/// and not for all.
std::string tool_path_csv(const ToolPath& path);

}  // namespace endmill
