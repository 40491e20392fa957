// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"

namespace endmill {

/// Checks that material can be removed along the path.
/// \throws DomainError if a tip is not within 1e9 mm.
/// \throws GeometryError if the axis of a point is not +z.
void require_removable(const ToolPath& path);

/// Whether the cutter has come down at the first point of the path: its kind is `Plunge`
/// or `Cut`.
/// \pre the path has a point.
bool cuts_at_start(const ToolPath& path);

}  // namespace endmill
