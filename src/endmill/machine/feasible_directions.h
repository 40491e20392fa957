// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/kinematics.h"

/// \file
/// The feasible tool motion: all directions that the tool of a machine can take within
/// its rotary limits.

namespace endmill {

/// Part of the border of a set of directions, along a meridian or a parallel: unit
/// vectors from one end to the other.
using DirectionCurve = std::vector<Vec3>;

/// The set of tool directions within rotary limits.
///
/// C,A: two opposite sectors about the pole. A,B: a rectangle between meridians through
/// R1 and parallels about R1, and further patches behind R1 if R2 turns beyond 90
/// degrees. The set is an arc of a great circle if one axis is at rest, and the pole
/// alone if both are.
/// Source: [KangSuh, section 3]; docs/methods/five-axis-setup.md, section 3.
class FeasibleDirections {
public:
    /// \param frame axes at zero.
    /// \param limits each range contains 0 and is at most 2 pi wide; the range of the
    ///         axis next to the tool (phi in C,A, theta in A,B) stays within [-pi, pi].
    /// \throws DomainError if the limits do not hold this to 1e-9 rad.
    FeasibleDirections(const RotaryFrame& frame, const RotaryLimits& limits);

    const RotaryFrame& frame() const { return frame_; }     ///< axes at zero, as given
    const RotaryLimits& limits() const { return limits_; }  ///< as given

    /// Tests whether one of the two solutions for a direction lies within the limits, to
    /// `turn_tolerance` for each angle. The pole always belongs to the set.
    /// \pre `direction` is unit.
    bool contains(const Vec3& direction) const;

    /// Solid angle of the set in sr; overlaps count once, arcs and points are 0. Absolute
    /// error below 1e-13.
    double solid_angle() const;

    /// The border, one curve for each edge, for drawing. An arc or a point is its own
    /// border; the whole sphere has none.
    /// \param step largest distance of neighbouring points in azimuth and latitude, rad.
    /// \throws DomainError if the step is below 1e-5.
    std::vector<DirectionCurve> border(double step) const;

private:
    RotaryFrame frame_;
    RotaryLimits limits_;
};

/// The tool directions of a machine, in its own frame. Source: [KangSuh, figure 5].
/// \throws DomainError as `machine_frame` and the constructor of FeasibleDirections.
FeasibleDirections feasible_directions(const MachineConfiguration& configuration,
                                       const RotaryLimits& limits);

}  // namespace endmill
