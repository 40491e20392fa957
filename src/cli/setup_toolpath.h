// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/setup_options.h"

namespace endmill {

/// Runs `setup` with --path. It finds a rotation of the part and a clamping position with
/// which the machine runs the path, and writes summary.json.
/// \throws FormatError, LimitError as `read_program`; GeometryError with the point if there
///         is no such setup; DomainError for options that --path excludes, and unless there
///         is one machine with two rotary axes that tilt the tool.
ExitCode run_setup_toolpath(const SetupCommandOptions& options);

}  // namespace endmill
