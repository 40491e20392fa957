// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// What is accepted before the reader gives up.
struct AptReadOptions {
    double max_extent_mm = 1e6;            ///< largest magnitude of a coordinate
    std::size_t most_points = 10'000'000;  ///< of the path
};

/// Whether the first statement of `text` is one of those that `parse_apt` knows.
bool is_apt(std::string_view text);

/// Reads CL data in the words that `apt` writes, and REMARK, PPRINT, `$$` (comments),
/// LOADTL, COOLNT, STOP (nothing to do). Small letters and blanks between words do not
/// matter; numbers are plain decimals. CUTTER without a corner radius is a flat end mill.
/// What follows FINI is left out, which a remark says. Moves are as `feed_move` has them;
/// the first is a plunge unless it is a rapid. All points are of pass 0.
/// \param file the name for messages.
/// \throws FormatError E_APT with the line for any other statement or unit, a wrong count
///         of numbers, a feed or a speed that is not above 0, a cutter that cannot be or
///         is not the first, an axis whose length is not 1 (`unit_axis`); if there
///         is no GOTO. E_RANGE for a coordinate beyond the limit, E_LIMIT for a line over
///         1 MiB, E_EMPTY for an empty text.
/// \throws LimitError for more points than the limit.
Program parse_apt(std::string_view text, const std::string& file,
                  const AptReadOptions& options = {});

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
