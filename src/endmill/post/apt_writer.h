// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/written_program.h"

namespace endmill {

/// What a path does not say of itself.
struct AptOptions {
    std::string name = {};                       ///< of the part, for PARTNO
    std::optional<Cutter> cutter = {};           ///< for CUTTER, left out if unknown
    std::optional<double> feed_mm_per_min = {};  ///< where the path gives none
    std::optional<double> spindle_rpm = {};      ///< where the path gives none
    int decimals = 4;  ///< of coordinates, feeds, speeds; 0 to 9
};

/// The path as CL data in the words of APT (ISO 4343): PARTNO, UNITS/MM, CUTTER, then
/// SPINDL and FEDRAT where they change, RAPID before each rapid move, GOTO to each tip,
/// with the axis where that is not +z, and FINI. The cutter and axes are spelled so that
/// they read back to the same doubles. What a tool's number and a safe start are is the
/// post-processor's affair: neither is written.
/// Source: spec of the removal, section 7.
/// \throws DomainError as `gcode`, for points, decimals, feeds and speeds.
WrittenProgram apt(const ToolPath& path, const AptOptions& options = {});

}  // namespace endmill
