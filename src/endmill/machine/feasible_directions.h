// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/rotary_angles.h"

namespace endmill {

/// An edge of a set of directions, unit, from end to end: part of a meridian or a parallel.
using DirectionCurve = std::vector<Vec3>;

/// The feasible tool motion: all directions that the tool can take within the rotary limits.
/// C,A: two opposite sectors about the pole. A,B: a rectangle between meridians through R1 and
/// parallels about it, and beyond a quarter turn of R2 what lies behind R1. With one axis at
/// rest a great arc, with both the pole alone. Source: [KangSuh, section 3].
class FeasibleDirections {
public:
    /// \throws DomainError unless both ranges hold 0 and are at most 2 pi wide, and the second
    ///         axis, phi in C,A and theta in A,B, is within pi; each to 1e-9.
    FeasibleDirections(const RotaryFrame& frame, const RotaryLimits& limits);

    const RotaryFrame& frame() const { return frame_; }     ///< the axes at zero
    const RotaryLimits& limits() const { return limits_; }  ///< as given

    /// Whether some turns within the limits give the direction, to `turn_tolerance` each.
    /// The pole always is.
    /// \pre `direction` is unit.
    bool contains(const Vec3& direction) const;

    /// In sr, overlaps counted once; 0 for arcs and points. Absolute error below 1e-13.
    double solid_angle() const;

    /// The border, edge by edge, for pictures; neighbouring points are at most `step` apart in
    /// azimuth and latitude. An arc or point is its own border; the whole sphere has none.
    /// \param step rad. \throws DomainError unless it is at least 1e-5.
    std::vector<DirectionCurve> border(double step) const;

private:
    RotaryFrame frame_;
    RotaryLimits limits_;
};

/// The same of a machine, in its own directions. Source: [KangSuh, figure 5].
/// \throws DomainError as `machine_frame` and the constructor.
FeasibleDirections feasible_directions(const MachineConfiguration& configuration,
                                       const RotaryLimits& limits);

}  // namespace endmill
