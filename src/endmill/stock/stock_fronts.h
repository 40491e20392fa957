// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/engagement.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Which fronts `for_each_ball_front` looks at, and how finely.
struct BallFrontTask {
    const ToolPath* path;                 ///< outlives the task
    Cutter cutter;                        ///< a ball
    std::span<const std::size_t> points;  ///< of the path after its first, rising
    int rows = 96;                        ///< cells across the feed; even
    int columns =
        128;  ///< cells about the axis across the feed, and azimuths of the shank
    std::function<void(double share)> progress = {};  ///< called now and then, if set
};

/// Takes from `stock`, move by move, what the ball-end mill sweeps along the path, as
/// `remove_along` does, and calls `visit(number, front)` before the move to each of the
/// points, with its number among these: which part of the front is in the stock in the middle
/// of the move.
///
/// A place is in the stock if it lies below its surface, linear between the centres of the
/// cells, as the move finds it: an upright wall is known to half a cell. The shank is a column an azimuth: what of the stock stands
/// higher than the ball's centre there. The rim is looked at 256 azimuths, a little below the
/// highest engaged place. A move straight up or down engages nothing.
/// Source: spec of ball-end milling, section 12, `stock`.
///
/// Every move finds what the one before it left, so one thread cuts, move by move; it copies
/// the stock around each middle, and the other threads look at the copies. Beside the stock it
/// takes up to 64 MB, or two copies if they are larger. The fronts and the stock are the same with any number of threads.
///
/// \throws DomainError unless the cutter is a ball, rows are even and above 0, there is a
///         column, and the points are as said; as `remove_along`.
/// \throws GeometryError as `remove_along`.
void for_each_ball_front(
    HeightStock& stock, const BallFrontTask& task,
    const std::function<void(std::size_t number, const BallFront& front)>& visit);

}  // namespace endmill
