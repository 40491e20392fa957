// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/stock/detail/tile_heights.h"

namespace endmill {

/// Computes `StraightSweep::height` of a bull-nose cutter at the centres of the cells, in
/// mm. It is infinite where the cutter does not pass.
///
/// The result may be too large, up to infinite, in two cases that do not change the
/// stock: where the height is not below `tile`, and where `move.is_continued` and the
/// cutter is lowest at the start of the move.
///
/// Over a cell, the height of the cutter is a convex function of its position along the
/// move. Most cells need no iteration: on a short move the minimum lies at the end, or
/// the tangent at the end shows that the cell is already lower. For the others Newton's
/// method finds the sine of the corner's angle, eight cells at a time.
/// \param tile heights before the move, mm.
void bull_heights(HeightStock::ConstTile tile, const TilePlace& place,
                  const Cutter& cutter, const SweptMove& move, TileHeights& heights);

}  // namespace endmill
