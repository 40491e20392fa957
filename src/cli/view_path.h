// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "cli/view_frame.h"
#include "cli/view_input.h"
#include "endmill/cutter/cutter.h"
#include "endmill/post/program.h"

namespace endmill {

/// The path of a page, and its cutter if that is known.
struct ViewPath {
    Program program;
    std::optional<Cutter> cutter = {};
};

/// Reads the path or program of a page as `verify` does: with the machine and the tool of the
/// options, of the summary beside it, or of the summary of a command that read it, which also
/// states how.
/// \throws FormatError, LimitError, DomainError as read_program_for.
ViewPath read_view_path(const ViewInput& input, const ViewOptions& options);

/// Adds `path` to the object of a page; also `plots` of an engagement, and `machine` for a path
/// that a machine with rotary axes runs.
/// \throws FormatError, LimitError as the readers of the engagement.
void add_path_view(Json& head, const ViewPath& path, const ViewInput& input,
                   const ReadLimits& limits, ViewFrame& frame);

}  // namespace endmill
