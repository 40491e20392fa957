// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "endmill/cutter/cutter.h"
#include "endmill/cutter/tool.h"
#include "endmill/path/tool_path.h"
#include "endmill/stock/height_stock.h"

namespace endmill {

/// A cut, or a contact with shank or holder, that is no deeper does not count: rounding.
inline constexpr double least_cut_depth = 1e-9;  // mm

/// What `remove_along` looks at beside the cutter.
struct RemovalOptions {
    /// Cylinders above the tip that must not touch the stock: shank and holder.
    std::vector<ToolCylinder> body = {};
};

/// Moves of one kind, such as those that must not cut and do.
struct MoveCount {
    std::size_t count = 0;
    std::optional<std::size_t> first = {};  ///< number of the point to which it leads
    double deepest = 0;                     ///< mm, over all of them
};

/// What a path took from a stock, move by move. A move has the number of the point to
/// which it leads.
struct Removal {
    std::vector<double> removed;  ///< mm^3, by each move; one a point
    /// mm, downwards at a cell, by each move; of a rapid at cells further inside the cutter
    /// than 1e-9 of its radius, as on the rim itself rounding decides.
    std::vector<double> deepest;
    double total = 0;                 ///< mm^3; the sum of all moves
    std::size_t air_moves = 0;        ///< that cut nothing
    MoveCount rapid_cuts;             ///< rapid moves that cut
    MoveCount collisions;             ///< moves on which shank or holder meets the stock
    std::optional<HeightRange> left;  ///< of what is left, if anything is
};

/// Takes from `stock`, move by move, what `cutter` sweeps on its way along `path`: after
/// it the height of each cell is the least of what it was and of `StraightSweep::height`
/// of every move, at the cell's centre, within 1e-12 of the size of path and cutter.
///
/// All kinds of move cut. The first point is where the cutter starts: if its kind is
/// `Plunge` or `Cut` the cutter is taken to have come down there, so that it cuts at this
/// place; of another kind it cuts only from the first move on.
///
/// A shank or holder collides if it would be more than `least_cut_depth` inside the
/// stock, as each move finds it where it arrives over new ground, and as the move leaves
/// it. What the cutter takes on the same move does not count against a cylinder that is
/// no wider.
///
/// The work is done by tiles of the stock, each with its moves in order, on all threads;
/// the volumes are summed as whole multiples of a fixed 2^-60 of what the stock may hold.
/// So the result is the same, to the bit, for every number of threads. Beside the result
/// it takes about a byte a cell, and 2 MB.
/// Source: spec of the removal, sections 1 and 3.
///
/// \param path tips along +z.
/// \throws DomainError if a tip is not within 1e9 mm, or a cylinder has no diameter.
/// \throws GeometryError if the axis of a point is not +z.
Removal remove_along(HeightStock& stock, const ToolPath& path, const Cutter& cutter,
                     const RemovalOptions& options = {});

/// What the move to point `number` takes in a minute, in mm^3: nothing without a feed, for a
/// rapid, which does not go at it, for a move without length, and where the number would
/// overflow.
/// \pre `removal` is of `path`.
std::optional<double> removal_rate(const Removal& removal, const ToolPath& path,
                                   std::size_t number);

/// The removal rates of a path, in mm^3/min.
struct RemovalRates {
    double greatest;
    double mean;  ///< over the time of all moves that have a rate
};

/// \return nothing if no move has a rate. \pre As `removal_rate`.
std::optional<RemovalRates> removal_rates(const Removal& removal, const ToolPath& path);

}  // namespace endmill
