// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/cutter/tool.h"
#include "endmill/stock/detail/move_bins.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// A cutter and the cylinders above it, prepared for the loops over the cells.
struct SweepingTool {
    Cutter cutter;
    Cutter
        /// Narrower by 1e-9 of its radius; a rapid cuts if this cutter does.
        narrowed_cutter;
    std::vector<BodyCylinder> body;  ///< narrower by the same share
    double reach;                    ///< mm, radius of the widest of all
};

/// Returns the tool of `cutter` and `body`.
SweepingTool sweeping_tool(const Cutter& cutter, std::span<const ToolCylinder> body);

/// Result of some consecutive moves: one number per move in each vector.
struct PartOfRemoval {
    double unit;                        ///< unit of the volumes, mm^3
    std::vector<std::int64_t> volumes;  ///< removed volumes, in units
    std::vector<double> deepest;        ///< mm, greatest depth of the cut
    std::vector<double> body_depths;    ///< mm, depth of shank or holder in the stock
};

/// Removes the volumes that the moves sweep from the stock, on all threads.
/// \param moves the moves that `bins` holds.
/// \param unit in mm^3. The volume of each tile and move is rounded to a multiple of it,
///        so that the sums do not depend on the order of the additions.
PartOfRemoval remove_part(HeightStock& stock, std::span<const SweptMove> moves,
                          const MoveBins& bins, const SweepingTool& tool, double unit);

}  // namespace endmill
