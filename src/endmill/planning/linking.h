// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "endmill/path/tool_path.h"

namespace endmill {

/// Contacts along one line of the surface, in the direction of the rising parameter.
using Pass = std::vector<SurfaceContact>;

/// In which sense neighbouring passes are cut.
enum class PassOrder {
    ZigZag,  ///< every other one backwards, linked along the part
    OneWay,  ///< all forwards; between them the cutter is lifted, moved and lowered
};

/// How passes become a path.
struct LinkOptions {
    PassOrder order = PassOrder::ZigZag;
    Vec3 axis = Vec3::UnitZ();  ///< unit, from the tip to the spindle
    double safe_height = 0;     ///< mm along the axis, of the tip when it is lifted
};

/// Joins `passes` to one path. Its first point is reached by a plunge.
/// Source: [KimChoi, fig. 12, 13] show the zigzag.
/// \throws GeometryError if the ball cannot touch a contact (N . axis <= 0), or if the
/// cutter is to be lifted to a height below its path.
ToolPath link_passes(std::span<const Pass> passes, const BallCutter& cutter,
                     const LinkOptions& options);

/// Joins the paths over the surfaces of a part to one, in their order: from each the
/// cutter is lifted, moved over the start of the next and lowered. Passes count on, and
/// each point's `patch` is the number of its path; a path without points is passed over.
/// \throws GeometryError if the safe height lies below a path.
ToolPath join_paths(std::span<const ToolPath> paths, const LinkOptions& options);

}  // namespace endmill
