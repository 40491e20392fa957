// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/command.h"
#include "cli/path_options.h"

namespace endmill {

/// Whether a file holds a tool path. A file with the extension of a part holds none; of
/// other files the content decides.
bool is_tool_path(const std::string& file, const ReadLimits& limits);

/// Reads a tool path and reports lengths, time, tools, feeds and extent.
/// \throws DomainError, FormatError, LimitError as `read_program_for`.
ExitCode report_path(const PathOptions& path, const CommonOptions& options);

}  // namespace endmill
