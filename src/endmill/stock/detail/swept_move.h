// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

/// A straight move of the tip in the form that the loops over cells need: start,
/// direction and length in the xy plane, and slope. A vertical move is represented by its
/// lower end, with length 0, because the cutter is open above.
struct SweptMove {
    double x;            ///< mm, tip at the start
    double y;            ///< mm, tip at the start
    double z;            ///< mm, tip at the start
    double rise;         ///< mm, z at the end minus z at the start
    double length;       ///< mm, in the xy plane
    double slope;        ///< rise / length; 0 for a vertical move
    double direction_x;  ///< unit direction in the xy plane
    double direction_y;  ///< unit direction in the xy plane
    /// Whether the move starts where the move before it ended and that move has been
    /// removed: the stock is then nowhere above the cutter at the start.
    bool is_continued = false;
    bool is_rapid = false;  ///< whether the move must not cut
};

/// Returns the move between two tips.
/// \param from, to tips in mm.
SweptMove swept_move(const Vec3& from, const Vec3& to);

}  // namespace endmill
