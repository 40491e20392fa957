// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

/// A straight move of the tip, taken apart as `StraightSweep` does: its direction over
/// the xy plane, its length there and its slope. One that is vertical stands at its lower
/// end.
struct SweptMove {
    double x;  ///< mm, of the tip where it begins
    double y;
    double z;
    double rise;         ///< mm, z at the end less z
    double length;       ///< mm, over the xy plane
    double slope;        ///< rise / length; 0 for a vertical move
    double direction_x;  ///< over the xy plane, unit
    double direction_y;
    /// It begins where the move before it ended, which has been taken: the stock is nowhere
    /// above the cutter at the start.
    bool is_continued = false;
    bool is_rapid = false;  ///< it must not cut
};

/// \param from, to tips in mm.
SweptMove swept_move(const Vec3& from, const Vec3& to);

}  // namespace endmill
