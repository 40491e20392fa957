// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Internal to simulation: what a bull-nose cutter leaves over the cells of one tile.

#include "endmill/simulation/tile_heights.h"

namespace endmill {

/// StraightSweep::height of a bull-nose cutter at the centres of the cells, in mm;
/// infinite where it does not pass, and perhaps where it is not below `tile`.
///
/// Over a cell the height is a convex function of the cutter's position. Most cells of a
/// short move find its least at one of the ends; the tangents there bound it from below
/// for the others, and what is left is found by a bracketed Newton iteration, eight cells
/// at a time.
void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, TileHeights& heights);

}  // namespace endmill
