// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "cli/command.h"
#include "endmill/cutter/cutter.h"
#include "endmill/files/path_file.h"

namespace endmill {

/// The point of the cutter that the coordinates of a program give.
enum class ProgrammedPoint { Tip, Centre };

/// The tool path that a command reads, and how.
struct PathOptions {
    std::string file;
    std::optional<Cutter> cutter;              ///< empty: that of the path or its summary
    std::optional<double> arc_tolerance = {};  ///< mm, from a program's arc to its chords
    ProgrammedPoint programmed_point = ProgrammedPoint::Tip;
    bool block_delete = false;  ///< skip blocks that begin with /
};

/// The argument TOOLPATH and the option --cutter.
void add_path_options(CLI::App& command, PathOptions& path);

/// The options on how a program is read.
void add_reading_options(CLI::App& command, PathOptions& path);

/// Adds them to a summary: programmed_point, arc_tolerance_mm, block_delete.
void add_reading(Json& summary, const PathOptions& path);

/// How the path is read.
/// \throws DomainError as `read_program_for`.
PathReadOptions path_reading(const PathOptions& path, const std::optional<Cutter>& cutter,
                             const CommonOptions& options);

/// Reads the path.
/// \param cutter what is known of it before the path is read.
/// \throws DomainError for an option that says nothing of a file of this kind, and if the
///         centre is programmed and `cutter` is none: where the tip is would not be known;
///         FormatError, LimitError as `read_program`.
Program read_program_for(const PathOptions& path, const std::optional<Cutter>& cutter,
                         const CommonOptions& options);

}  // namespace endmill
