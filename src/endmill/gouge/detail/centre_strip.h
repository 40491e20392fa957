// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"

namespace endmill {

/// A straight move of a ball by its centre, in mm.
struct BallMove {
    Vec3 from;
    Vec3 to;
};

/// Where the centre of a ball goes on a straight move, and the axis of the shank above it:
/// all points c + s P with c on the move and s >= 0, P the axis. The ball and its shank,
/// of the same radius R, sweep what is nearer than R to it. A convex plane region, in a
/// plane that holds P; a ray for a move along P, and for one that is shorter across P than
/// 1e-9 of its place and length.
class CentreStrip {
public:
    /// \param axis P, unit. \pre the move is finite.
    CentreStrip(const BallMove& move, const Vec3& axis);

    /// Its point nearest to `point`, right to a few roundings of the numbers involved.
    Vec3 nearest(const Vec3& point) const;

private:
    Vec3 base_;      // where the move starts
    Vec3 axis_;      // unit
    Vec3 feed_;      // unit, across the axis
    double length_;  // of the move along feed_
    double rise_;    // of the move along axis_
};

}  // namespace endmill
