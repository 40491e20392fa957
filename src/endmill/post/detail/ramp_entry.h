// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "endmill/path/tool_path.h"

namespace endmill {

/// A path whose descents go down slopes.
struct RampedPath {
    ToolPath path;             ///< with the points of the slopes; all are plunges
    std::size_t ramps = 0;     ///< descents that became slopes
    std::size_t straight = 0;  ///< descents that stay straight, for want of cuts or room
};

/// `path` with slopes instead of vertical plunges. A slope goes forward along the cutting
/// moves that follow the plunge, and back to their start, as often as needed. Meanwhile
/// the tool descends evenly from the height where the plunge began to the path. Plunges
/// one below the other with one tool are one descent, with the feed of the last one.
///
/// No point of a slope lies below the path under it: its height over the path falls from
/// the depth of the plunge to 0. A raised cutter removes nothing that the cutter on the
/// path leaves, so the remaining material is the same.
///
/// A plunge stays straight if no cut follows it with the same tool, or if the cuts that
/// follow it are so short, seen from above, that the slope would go back and forth more
/// than 50 times.
/// \param path the path; its first point is reached from above.
/// \param start_height mm, height at which the tool is over the first point.
/// \param tangent of the angle between slope and path, above 0.
/// \throws DomainError unless the tangent is a number above 0.
/// Source: docs/methods/removal.md, section 6.
RampedPath with_ramps(const ToolPath& path, double start_height, double tangent);

}  // namespace endmill
