// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/setup_options.h"

namespace endmill {

/// Fits sector or rectangle to the directions of --points, the tool axis at +z.
/// \return Yes unless they do not fit: no pose within limits, or in no open hemisphere.
/// \throws FormatError, LimitError as `read_directions`; DomainError for options that do not
///         go with it.
ExitCode run_setup_points(const SetupCommandOptions& options);

}  // namespace endmill
