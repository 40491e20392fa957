// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"

namespace endmill {

/// A machine program or CL data as it was read.
struct Program {
    ToolPath path;                     ///< tips, with conditions where it gives any
    std::optional<Cutter> cutter;      ///< if the program names one, as APT does
    std::vector<std::string> remarks;  ///< for a person: units, motion left out
    double position_error_mm = 0;      ///< of a coordinate: the rounding of its text
};

}  // namespace endmill
