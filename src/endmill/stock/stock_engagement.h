// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/engagement.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

/// \file
/// The engaged region of a cutter on each move, and the distance between a path and a
/// block.

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
/// cells. The material that the first half of the move removes lies behind these places.
/// Intervals consist of whole cells. The error of an end is therefore at most half a
/// cell, and one pitch at an upright wall. Rings of the same width continue up the
/// cylinder to the top of the stock. A move without length and a move straight up engage
/// nothing.
/// Source: docs/methods/ball-end-milling.md, section 12.
///
/// \param path tips along +z.
/// \throws DomainError unless there is a ring and an azimuth, or if a tip is not within
///         1e9 mm.
/// \throws GeometryError if the axis of a point is not +z.
void for_each_engagement(
    HeightStock& stock, const ToolPath& path, const Cutter& cutter,
    const std::function<void(std::size_t number, const Engagement& engagement)>& visit,
    const EngagementOptions& options = {});

/// The moves whose engaged fronts `for_each_ball_front` determines, and the resolution.
struct BallFrontTask {
    const ToolPath* path;  ///< tips along +z; not null; must outlive the task
    Cutter cutter;         ///< a ball
    /// Numbers of the points at which the moves end, rising; not the first point.
    std::span<const std::size_t> points;
    int rows = 96;  ///< cells across the feed; even
    /// Number of cells about the axis across the feed, and of azimuths of the shank.
    int columns = 128;
    /// If set, it is called with the finished share, 0 to 1.
    std::function<void(double share)> progress = {};
};

/// Removes the material along the path as `remove_along` does. Before the move to each of
/// the task's points it calls `visit(number, front)` with the point's number among these
/// and the engaged part of the front in the middle of the move.
///
/// A place is engaged if it lies below the surface of the stock before the move, which is
/// interpolated linearly between the centres of the cells. The position of an upright
/// wall is accurate to half a cell. On the shank, each azimuth stores the height of the
/// stock above the ball's centre. The engaged angle is sampled at 256 azimuths, a little
/// below the highest engaged place. A move straight up or down engages nothing.
/// Source: docs/methods/ball-end-milling.md, section 12.
///
/// One thread cuts the moves in order, because each move needs the stock after the move
/// before. It copies the stock around the middle of each move, and the other threads
/// evaluate the copies. The copies take up to 64 MB, or the memory of two copies if one
/// copy exceeds 32 MB. Fronts and stock are the same with any number of threads.
///
/// \param visit may be called from several threads at a time, each time with another
///        number.
/// \throws DomainError unless there is a path, the cutter is a ball, rows are even and
///         positive, columns are positive, and the points rise within the path after its
///         first point; or if a tip is not within 1e9 mm.
/// \throws GeometryError if the axis of a point is not +z.
void for_each_ball_front(
    HeightStock& stock, const BallFrontTask& task,
    const std::function<void(std::size_t number, const BallFront& front)>& visit);

/// Returns the distance in mm between a ball-end mill with its shank and a block, on the
/// moves to `points`. It is 0 if the cutter meets the block on one of them, and infinite
/// without points. The error is below 1e-6 of the longest move. If the cutter enters the
/// block by more than that, the result is exactly 0.
/// \param path tips along +z; the axis is not checked.
/// \param points of the path after its first.
/// \throws DomainError unless the cutter is a ball and the points lie in the path after
///         its first.
double stock_gap(const ToolPath& path, std::span<const std::size_t> points,
                 const Cutter& cutter, const Block& block);

}  // namespace endmill
