// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
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

/// Contacts of a pass that are cut without a break, in the order in which they are.
struct PassPiece {
    int pass;  ///< its number, from 0, rising
    Pass contacts;
};

/// A path and how many of the links between its pieces are lifted.
struct LinkedPath {
    ToolPath path;
    std::size_t lifted_links;
};

/// Joins `pieces`, in their order, to one path: by a link at cutting feed where
/// `is_clear` allows it from one contact to the next, else lifted. One-way passes are
/// lifted from one to the next in any case, which does not count.
/// 	hrows GeometryError as link_passes.
LinkedPath link_pieces(std::span<const PassPiece> pieces, const BallCutter& cutter,
                       const LinkOptions& options,
                       const std::function<bool(const SurfaceContact& from,
                                                const SurfaceContact& to)>& is_clear);

/// Joins the paths over the surfaces of a part to one, in their order: from each the
/// cutter is lifted, moved over the start of the next and lowered. Passes count on, and
/// each point's `patch` is the number of its path; a path without points is passed over.
/// \throws GeometryError if the safe height lies below a path.
ToolPath join_paths(std::span<const ToolPath> paths, const LinkOptions& options);

}  // namespace endmill
