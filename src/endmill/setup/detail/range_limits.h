// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numbers>

#include "endmill/machine/axis_limits.h"
#include "endmill/setup/setup_pose.h"

namespace endmill {

/// Limits of the ranges of a pose, without signs, as the search over whole cones takes
/// them. All comparisons allow `turn_tolerance`.
struct RangeLimits {
    double width = 2 * std::numbers::pi;  ///< rad, of the window
    double far = std::numbers::pi;        ///< rad, of the larger of m0 and m1
    double near = std::numbers::pi;       ///< rad, of the smaller of them; at most `far`

    /// Takes the limits of the rotary axes. The tilt of C,A ends at 180 degrees, R2 of
    /// A,B at 90 degrees.
    RangeLimits(RotaryFamily family, const RotaryLimits& limits);

    /// Tests whether the part can be turned so that m0 and m1 (rad) are within the
    /// limits.
    bool hold(double m0, double m1) const
    {
        return std::max(m0, m1) <= far + turn_tolerance &&
               std::min(m0, m1) <= near + turn_tolerance;
    }

    double widest() const { return width + turn_tolerance; }  ///< limit of w, rad
    double farthest() const { return far + turn_tolerance; }  ///< limit of m0 and m1, rad
    /// Limit of h, rad.
    double highest() const { return far + near + 2 * turn_tolerance; }
};

/// Tests whether m0 or m1 may rise beyond `level` within the limits without a change of
/// the objective. A search then need not look at sets that end at `level`.
/// \param measure the objective. \param limits of the ranges.
/// \param level rad, of m0 or m1. \param other rad, a lower bound of the other of them.
inline bool rises_freely(const PoseMeasure& measure, const RangeLimits& limits,
                         double level, double other)
{
    return measure.objective == SetupObjective::Tilt &&
           level < std::min(other, limits.near);
}

}  // namespace endmill
