// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {

/// Material that a move removed from a tile.
struct TileCut {
    double depths;   ///< mm, sum of the depths over the cells
    double deepest;  ///< mm, greatest depth of a cell
};

/// Lowers the heights of `tile` to `StraightSweep::height` of the move at the centres of
/// the cells, within rounding. Sums run over eight columns first and then over these in
/// order, so the result is the same to the bit with every register width of the machine.
TileCut cut_tile(HeightStock::Tile tile, const TilePlace& place, const Cutter& cutter,
                 const SweptMove& move);

/// A cylinder around the tool axis; open above, like the cutter.
struct BodyCylinder {
    double radius;  ///< mm
    double above;   ///< mm, height of its lower end above the tip
};

/// Returns the depth of the cylinder in the material in mm: the greatest height of a cell
/// above the cylinder's lower end, over all positions of the move; 0 if it touches
/// nothing.
double body_depth(HeightStock::ConstTile tile, const TilePlace& place,
                  const BodyCylinder& body, const SweptMove& move);

/// Returns the same depth, but only for cells that the cylinder does not cover at the
/// start of the move, and at the position where its rim reaches the cell.
double body_depth_on_arrival(HeightStock::ConstTile tile, const TilePlace& place,
                             const BodyCylinder& body, const SweptMove& move);

}  // namespace endmill
