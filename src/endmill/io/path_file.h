// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>

#include "endmill/io/read_limits.h"
#include "endmill/post/gcode_read_options.h"
#include "endmill/post/program.h"

namespace endmill {

/// The kinds of files that hold a tool path.
enum class PathFormat {
    Csv,        ///< with the columns of `tool_path_csv`
    Gcode,      ///< RS-274
    Canonical,  ///< what `rs274 -g` prints
    Apt,        ///< APT CL data
};

/// What a file that holds a path does not say of itself.
struct PathReadOptions {
    ReadLimits limits = {};       ///< on coordinates and memory; they rule over `gcode`'s
    GcodeReadOptions gcode = {};  ///< for machine programs
};

/// The kind of a file, by its content, or else by its extension: .csv; .apt, .cl, .cls;
/// .ngc, .nc, .gcode, .tap, .cnc, .mpf, in capitals or not.
/// \param path for its extension and messages.
/// \throws FormatError E_FORMAT for another kind of file, which is named if it is known.
PathFormat path_format(std::string_view content, const std::filesystem::path& path);

/// `options.gcode` as the limits bound it.
GcodeReadOptions gcode_reading(const PathReadOptions& options);

/// The tool path in the content of a file of any of these kinds.
/// \param path for its extension and messages.
/// \throws as `read_program`, which reads the file first.
Program parse_program(std::string_view content, const std::filesystem::path& path,
                      const PathReadOptions& options = {});

/// Reads a tool path from a file of any of these kinds.
/// \throws FormatError, LimitError as `read_file`, `path_format` and the reader of the
///         kind: `parse_tool_path`, `parse_gcode`, `parse_canonical`, `parse_apt`.
Program read_program(const std::filesystem::path& path,
                     const PathReadOptions& options = {});

}  // namespace endmill
