// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/path_file.h"

namespace endmill {

/// The point of the cutter to which the coordinates of a program refer.
enum class ProgrammedPoint { Tip, Centre };

/// The tool path of a command, and the options for reading it.
struct PathOptions {
    std::string file;
    std::optional<Cutter> cutter;  ///< default: that of the path or its summary
    std::optional<double> arc_tolerance = {};  ///< mm, from a program's arc to its chords
    ProgrammedPoint programmed_point = ProgrammedPoint::Tip;
    bool block_delete = false;  ///< skip blocks that begin with /
};

/// Adds the argument TOOLPATH and the option --cutter.
void add_path_options(CLI::App& command, PathOptions& path);

/// Adds the options for reading a program.
void add_reading_options(CLI::App& command, PathOptions& path);

/// Adds their values to a summary: programmed_point, arc_tolerance_mm, block_delete.
void add_reading(Json& summary, const PathOptions& path);

/// The options for the reader of the path.
/// \throws DomainError as `read_program_for`.
PathReadOptions path_reading(const PathOptions& path, const std::optional<Cutter>& cutter,
                             const CommonOptions& options);

/// Reads the path.
/// \param cutter the cutter, if it is known before the path is read.
/// \throws DomainError for an option that does not apply to the format of the file, and
///         if the centre is programmed and `cutter` is empty, since the tip is then not
///         known; FormatError, LimitError as `read_program`.
Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options);

}  // namespace endmill
