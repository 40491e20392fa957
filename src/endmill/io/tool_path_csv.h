// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "endmill/path/tool_path.h"

namespace endmill {

/// The tool path as a CSV file of the columns pass, point, move, tip_x_mm … tip_z_mm,
/// axis_x … axis_z, patch (if the path is over several), u, v, contact_x_mm … contact_z_mm, normal_x … normal_z, a line a
/// point. Numbers have the shortest text that reads back to the same double; the last
/// eight cells are empty where there is no contact. The same bytes with any number of
/// threads.
/// \throws DomainError if a number is not finite.
std::string tool_path_csv(const ToolPath& path);

}  // namespace endmill
