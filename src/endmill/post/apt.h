// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// \file
/// Reader and writer of CL data (cutter location data) in the words of APT.
///
/// Implemented in `apt_reader.cpp` and `apt_writer.cpp`.

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "endmill/cutter/cutter.h"
#include "endmill/path/tool_path.h"
#include "endmill/post/program.h"

namespace endmill {

/// What the APT reader accepts.
struct AptReadOptions {
    double max_extent_mm = 1e6;            ///< mm, largest magnitude of a coordinate
    std::size_t most_points = 10'000'000;  ///< largest number of path points
    /// Whether CUTTER may name several cutters, because a tool table gives that of each
    /// tool. The program then has none.
    bool several_cutters = false;
};

/// Whether the first statement of `text` is one that `parse_apt` knows.
bool is_apt(std::string_view text);

/// Reads CL data with the statements that `apt` writes, and with REMARK, PPRINT and `$$`
/// (comments) and COOLNT and STOP (no effect). Upper and lower case are equal,
/// and blanks between words are ignored. Numbers are plain decimals. CUTTER without a
/// corner radius is a flat end mill. A `$` at the end of a line continues the statement
/// in the next line, but not a text. SPINDL takes its words in any order, and may leave
/// out RPM or CLW; SPINDL/OFF stops the spindle, SPINDL/ON starts it again.
///
/// A move straight down is a plunge, straight up a retract, otherwise a cut; after RAPID
/// it is a rapid. The first move is a plunge unless it is a rapid. All points belong to
/// pass 0. Text after FINI is ignored; a remark reports it.
/// \param text the CL data.
/// \param file name of the file for messages.
/// \param options limits.
/// \throws FormatError with file and line. E_APT for any other statement or unit, a wrong
///         count of numbers, a feed or speed that is not above 0, an impossible cutter or
///         one that differs from the first unless the options allow it, an axis whose length is not 1 within 1e-4, or
///         if there is no GOTO. E_RANGE for a coordinate beyond the limit, E_LIMIT for a
///         line over 1 MiB, E_EMPTY for an empty text.
/// \throws LimitError for more points than the limit.
/// Source: docs/methods/removal.md, section 7.
Program parse_apt(std::string_view text, const std::string& file,
                  const AptReadOptions& options = {});

/// Data that the path does not contain, and the format of its CL data.
struct AptOptions {
    std::string name = {};              ///< name of the part, for PARTNO
    std::optional<Cutter> cutter = {};  ///< for CUTTER; without it there is no CUTTER
    std::optional<double> feed_mm_per_min = {};  ///< mm/min, for moves without a feed
    std::optional<double> spindle_rpm = {};  ///< rpm, for moves without a spindle speed
    int decimals = 4;  ///< digits after the point of coordinates, feeds, speeds; 0 to 9
    bool multax = false;  ///< whether MULTAX is written, and the axis of every point
};

/// The path as CL data in the words of APT (ISO 4343): PARTNO, UNITS/MM, CUTTER, then
/// SPINDL and FEDRAT where they change, RAPID before each rapid move, GOTO to each tip,
/// with the axis where it is not +z, and FINI. With `multax`, MULTAX follows UNITS and
/// every GOTO has its axis. LOADTL stands where the path names another tool. The cutter and
/// the axes are written exactly: reading gives the same doubles. A safe start is not
/// written; the post-processor that reads the data adds it.
/// \param path the path.
/// \param options format and missing data.
/// \throws DomainError for a path without points; for decimals outside 0 to 9; if a move
///         at feed has no feed; for a feed or spindle speed that is not above 0 after
///         rounding; for a negative tool number; for a number that is not finite.
/// Source: docs/methods/removal.md, section 7.
WrittenProgram apt(const ToolPath& path, const AptOptions& options = {});

}  // namespace endmill
