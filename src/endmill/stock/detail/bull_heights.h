// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/stock/detail/tile_heights.h"

namespace endmill {

/// StraightSweep::height of a bull-nose cutter at the centres of the cells, in mm;
/// infinite where it does not pass, and perhaps more, up to infinite, where it is not below
/// `tile`, or where `move.is_continued` and the cutter is lowest at the start.
///
/// Over a cell the height is a convex function of the cutter's position. Most cells find its
/// least at the end of a short move, or have been lower before: the tangent there bounds it
/// from below. What is left is found by Newton's iteration for the corner's angle, eight
/// cells at a time.
void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, TileHeights& heights);

}  // namespace endmill
