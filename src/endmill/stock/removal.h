// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// Options of `remove_along`.
struct RemovalOptions {
    /// Cylinders of shank and holder, above the tip, which must not touch the stock.
    std::vector<ToolCylinder> body = {};
};

/// A change of the tool within a path.
struct ToolChange {
    std::size_t first;  ///< number of the first point to which the new tool moves
    Cutter cutter;      ///< the shape that cuts from there on
    std::vector<ToolCylinder> body = {};  ///< cylinders of shank and holder
    /// mm, from the tip; above it the cutter does not cut. Five axes only.
    double cutting_length = std::numeric_limits<double>::infinity();
};

/// Statistics of the moves with a common property, such as the rapids that cut.
struct MoveCount {
    std::size_t count = 0;  ///< number of moves
    /// Number of the point to which the first of these moves leads.
    std::optional<std::size_t> first = {};
    double deepest = 0;  ///< mm, greatest depth of all of them
};

/// Material removed by a path, move by move. A move has the number of the point to which
/// it leads.
struct Removal {
    std::vector<double> removed;  ///< mm^3, one per point: volume removed by the move
    /// mm, one per point: greatest depth that the move cuts at a cell, measured
    /// downwards. For a rapid, only cells count that lie inside the cutter by more than
    /// 1e-9 of its radius, because on the rim of the cutter rounding decides whether it
    /// cuts.
    std::vector<double> deepest;
    double total = 0;           ///< mm^3, volume removed by all moves
    std::size_t air_moves = 0;  ///< number of moves that cut nothing
    MoveCount rapid_cuts;       ///< rapid moves that cut
    MoveCount collisions;       ///< moves on which shank or holder is in the stock
    /// Heights of the remaining stock; none if it is empty.
    std::optional<HeightRange> left;
};

/// Removes from `stock`, move by move, the volume that `cutter` sweeps along `path`. The
/// new height of each cell is the minimum of its old height and of
/// `StraightSweep::height` of every move at the cell's centre, accurate to 1e-12 of the
/// size of path and cutter.
///
/// All kinds of move cut. The first point is the start of the cutter. If its kind is
/// `Plunge` or `Cut`, we assume that the cutter plunged there and removed material.
/// Otherwise it removes material from the first move on.
///
/// Shank or holder collides if it is more than `touching_depth` inside the stock. This
/// is tested twice per move. On the stock before the move, only the cells that the
/// cylinder newly covers are tested. On the stock after the move, all cells that it
/// covers are tested. A cylinder that is not wider than the cutter is not tested before
/// the move, so that it does not collide with material that the same move removes.
///
/// The tiles of the stock are processed on all threads, each with its moves in order.
/// Volumes are summed as integer multiples of a power of two, about 2^-60 of the stock's
/// volume. The result is therefore the same to the bit with any number of threads.
/// Besides the result the function takes about one byte per cell and 2 MB.
/// Source: docs/methods/removal.md, section 1 (heights), section 3 (rapids,
/// collisions).
///
/// \param path tips along +z.
/// \throws DomainError if a tip is not within 1e9 mm, or a cylinder has no positive
///         diameter.
/// \throws GeometryError if the axis of a point is not +z.
Removal remove_along(HeightStock& stock, const ToolPath& path, const Cutter& cutter,
                     const RemovalOptions& options = {});

/// Returns the removal rate of the move to point `number`, in mm^3/min.
/// \return nothing if the move has no feed or no length, if it is a rapid, or if the rate
///         overflows. A rapid does not move at the feed.
/// \pre `removal` is the result of `path`.
std::optional<double> removal_rate(const Removal& removal, const ToolPath& path,
                                   std::size_t number);

/// Removal rates of a path, in mm^3/min.
struct RemovalRates {
    double greatest;  ///< of one move
    double mean;      ///< volume over time of all moves that have a rate
};

/// Returns the removal rates of a path.
/// \return nothing if no move has a rate.
/// \pre `removal` is the result of `path`.
std::optional<RemovalRates> removal_rates(const Removal& removal, const ToolPath& path);

}  // namespace endmill
