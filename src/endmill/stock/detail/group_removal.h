// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "endmill/cutter/tool.h"
#include "endmill/stock/detail/move_bins.h"
#include "endmill/stock/detail/tile_cut.h"

namespace endmill {

/// A cutter and the cylinders above it, as the loops want them.
struct SweepingTool {
    Cutter cutter;
    Cutter
        slim_cutter;  ///< a little narrower: what a rapid must not bring into the stock
    std::vector<BodyCylinder> body;  ///< as much narrower
    double reach;                    ///< mm, radius of the widest of all
};

/// The tool of `cutter` and `body`.
SweepingTool sweeping_tool(const Cutter& cutter, std::span<const ToolCylinder> body);

/// What some moves did, one number a move.
struct PartOfRemoval {
    double unit;                        ///< mm^3
    std::vector<std::int64_t> volumes;  ///< removed, in units
    std::vector<double> deepest;        ///< mm, of a cut
    std::vector<double> body_depths;    ///< mm, of shank or holder in the stock
};

/// Takes from the stock what the moves sweep.
/// \param moves those that `bins` holds.
/// \param unit in mm^3: volumes are rounded to multiples of it, a tile and move at a time,
///        so that their sums do not depend on the order of the additions.
PartOfRemoval remove_part(HeightStock& stock, std::span<const SweptMove> moves,
                          const MoveBins& bins, const SweepingTool& tool, double unit);

}  // namespace endmill
