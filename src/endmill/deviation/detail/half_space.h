// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// The half space of all x with normal . x >= least.
struct HalfSpace {
    Vec3 normal;   ///< unit
    double least;  ///< mm
};

/// Returns the reference point of a sweep (one corner radius above the tip) that is
/// nearest to `place`. Points above the reference points belong to the sweep too; if one
/// of these is nearest, the reference point under it is returned.
Vec3 nearest_reference(const StraightSweep& sweep, const Vec3& place);

/// Returns a half space that contains all that a cutter clears while its reference points
/// (one corner radius above the tip) lie in a box, open above. Its normal is the
/// direction from `place` to the disc around which the corner is rolled.
/// Source: paper/notes/deviation-bounds.md, eq. (f).
/// \param nearest the point of the box that is nearest to `place`, mm.
HalfSpace half_space(const Cutter& cutter, const Vec3& place, const Vec3& nearest);

/// Returns such a half space for one sweep. It always contains the swept volume. The
/// distance of `place` from it is the distance from the swept volume if the corner faces
/// the place and the move is horizontal, and close to it otherwise.
HalfSpace half_space_beyond(const StraightSweep& sweep, const Vec3& place);

}  // namespace endmill
