// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/path/tool_path.h"

namespace endmill {

/// `path` with descents that are rapids down to `distance` above the point at which they
/// end. The rest of a descent stays a plunge. All these moves are vertical, and the tip
/// passes the same places. A descent that is no longer than `distance` stays as it is, and
/// so does one that no cut with the same tool follows: it drills.
/// \param path the path; its first point is reached from above.
/// \param start_height mm, height at which the tool is over the first point.
/// \param distance mm, above 0.
/// \throws DomainError unless the distance is a number above 0.
/// Source: docs/methods/removal.md, section 6.
ToolPath with_rapid_approach(const ToolPath& path, double start_height, double distance);

}  // namespace endmill
