// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/engagement.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// How finely `for_each_engagement` looks.
struct EngagementOptions {
    int rings = 24;     ///< over the rounded corner; over the radius of a flat cutter
    int azimuths = 72;  ///< around each ring
};

/// Takes from `stock`, move by move, what `cutter` sweeps along `path`, as `remove_along`
/// does, and calls `visit(number, engagement)` before each move with the number of the
/// point to which it leads: which part of the cutter is in the stock in the middle of the
/// move.
///
/// A place of the cutter is engaged if it faces the way of the move and lies below the
/// stock, linear between the centres of the cells, as the move finds it: what the first
/// half of the move takes is behind these places. Places are the middles of equal cells of latitude (of equal
/// width along the profile) and azimuth, and intervals are whole cells: an end is off by a
/// cell's half at most, and by what a pitch matters: an upright wall is blurred by one. Rings go on up the
/// cylinder as far as there is stock, in the same width. A move that stays in place, and
/// one straight up, engages nothing.
/// Source: spec of ball-end milling, section 12, `stock`.
///
/// \throws DomainError unless there is a ring and an azimuth, and as `remove_along`.
/// \throws GeometryError as `remove_along`.
void for_each_engagement(
    HeightStock& stock, const ToolPath& path, const Cutter& cutter,
    const std::function<void(std::size_t number, const Engagement& engagement)>& visit,
    const EngagementOptions& options = {});

}  // namespace endmill
