// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/setup_options.h"

namespace endmill {

/// Runs `setup` with --points. It fits a sector (C,A) or a rectangle (A,B) to the
/// directions, with the tool axis at +z.
/// \return No if no pose within the limits exists, or no open hemisphere holds the
/// directions.
/// \throws FormatError, LimitError as `read_directions`; DomainError for options that
///         --points excludes.
ExitCode run_setup_points(const SetupCommandOptions& options);

}  // namespace endmill
