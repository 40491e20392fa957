// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/engagement.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Resolution of `for_each_engagement`.
struct EngagementOptions {
    /// Rings over the rounded corner, or over the radius of a flat cutter.
    int rings = 24;
    int azimuths = 72;  ///< cells around each ring
};

/// Removes the material along `path` as `remove_along` does. Before each move it calls
/// `visit(number, engagement)` with the number of the point to which the move leads and
/// the region of the cutter that is in the stock in the middle of the move.
///
/// The cutter is divided into rings of equal width along its profile and each ring into
/// equal azimuths. A cell is engaged if its middle faces the direction of the move and
/// lies below the stock before the move, interpolated linearly between the centres of the
/// cells. (The material that the first half of the move removes lies behind these
/// places.) Intervals consist of whole cells, so an end is off by at most half a cell,
/// and by one pitch at an upright wall. Rings of the same width continue up the cylinder
/// as far as there is stock. A move without length and a move straight up engage nothing.
/// Source: docs/mathematics/ball-end-milling.md, section 12.
///
/// \param path tips along +z.
/// \throws DomainError unless there is a ring and an azimuth, or if a tip is not within
///         1e9 mm.
/// \throws GeometryError if the axis of a point is not +z.
void for_each_engagement(
    HeightStock& stock, const ToolPath& path, const Cutter& cutter,
    const std::function<void(std::size_t number, const Engagement& engagement)>& visit,
    const EngagementOptions& options = {});

}  // namespace endmill
