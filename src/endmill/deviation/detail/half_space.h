// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// The half space normal . x >= least.
struct HalfSpace {
    Vec3 normal;   ///< unit
    double least;  ///< mm
};

/// Of the reference points of a sweep (one corner radius above the tips) and all above them
/// the nearest to `place`, or the reference point under it.
Vec3 nearest_reference(const StraightSweep& sweep, const Vec3& place);

/// A half space that holds all that a cutter clears whose reference points (one corner
/// radius above the tip) lie in a box, open above, of which `nearest` is the point nearest
/// to `place`: square to the way from there to what the corner is rolled around.
HalfSpace half_space(const Cutter& cutter, const Vec3& place, const Vec3& nearest);

/// The same for one sweep. It always holds the sweep; how far `place` lies beyond its
/// border is the distance between them where the corner faces the place and the move is
/// level, and about that elsewhere.
HalfSpace half_space_beyond(const StraightSweep& sweep, const Vec3& place);

}  // namespace endmill
