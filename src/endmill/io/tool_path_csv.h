// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "endmill/path/tool_path.h"

namespace endmill {

/// The tool path as a CSV file of the columns pass, point, move, tip_x_mm … tip_z_mm,
/// axis_x … axis_z, tool (if any point has one), patch (if the path is over several), u, v,
/// contact_x_mm … contact_z_mm, normal_x … normal_z, feed_mm_per_min and spindle_rpm (each
/// if any point has one), a line a point. Numbers have the shortest text that reads back
/// to the same double; what a point does not have is an empty cell. The same bytes with
/// any number of threads.
/// \throws DomainError if a number is not finite, or there are conditions or normals for some
/// points and not for all.
std::string tool_path_csv(const ToolPath& path);

/// The same with a last column, limit: what keeps the feed of each move from being higher.
/// \param limits words without commas and quotes, one a point; empty where there is none.
/// \throws DomainError as above, or unless there is a word for each point.
std::string tool_path_csv(const ToolPath& path, std::span<const std::string_view> limits);

}  // namespace endmill
