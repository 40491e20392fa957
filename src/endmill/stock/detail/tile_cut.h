// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/cutter/cutter.h"
#include "endmill/stock/detail/tile_heights.h"

namespace endmill {

/// What a move took from a tile.
struct TileCut {
    double depths;   ///< mm, the sum over its cells
    double deepest;  ///< mm, of one cell
};

/// Lowers the heights of `tile` to what `cutter` leaves on `move`: StraightSweep::height
/// at the centre of each cell, within rounding. The result is the same, to the bit, with
/// every width of the machine's registers: sums are taken in eight columns, then in order.
TileCut cut_tile(HeightStock::Tile tile, const TilePlace& place, const Cutter& cutter,
                 const SweptMove& move);

/// A cylinder around the cutter's axis, open above like the cutter itself.
struct BodyCylinder {
    double radius;  ///< mm
    double above;   ///< mm, from the tip to its lower end
};

/// How deep the cylinder would be in the material on the way: the largest height over its
/// lower end, in mm, of all positions; 0 if it is clear.
double body_depth(HeightStock::ConstTile tile, const TilePlace& place,
                  const BodyCylinder& body, const SweptMove& move);

/// The same where the cylinder arrives over a cell that it did not cover at the start of
/// the move: at the place where its rim gets there.
double body_depth_on_arrival(HeightStock::ConstTile tile, const TilePlace& place,
                             const BodyCylinder& body, const SweptMove& move);

}  // namespace endmill
