// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "endmill/core/tolerance.h"
#include "endmill/machine/rotary_limits.h"

namespace endmill {

/// What a setup is to have least of. w is the range of C (C,A) or of R1 (A,B), h = m0 + m1
/// that of the other axis, in rad. The paper's w h is no choice: it is 0 for every great arc,
/// however long.
enum class SetupObjective : std::uint8_t {
    FlooredArea,  ///< (w + floor)(h + floor), rad^2
    TotalRange,   ///< w + h, rad
    Tilt          ///< rad; C,A: max(m0, m1); A,B: max(w / 2, m0, m1)
};

/// The ranges of a pose: `width` of C (C,A) or R1 (A,B), and how far the other axis goes to
/// either side; rad, not negative.
struct PoseRanges {
    double width = 0;
    double m0 = 0;  ///< C,A: polar angle in the window; A,B: to positive latitudes
    double m1 = 0;  ///< C,A: polar angle opposite to it; A,B: to negative latitudes

    double height() const { return m0 + m1; }  ///< h, rad
};

/// An objective with all that it needs. It never falls as a range grows.
struct PoseMeasure {
    RotaryFamily family = RotaryFamily::CA;
    SetupObjective objective = SetupObjective::FlooredArea;
    double floor_rad = 5.9 * std::numbers::pi / 180;  ///< of FlooredArea; > 0

    /// rad^2 for FlooredArea, else rad. Relative error below 1e-15.
    double operator()(const PoseRanges& ranges) const;

    /// Widths from here on make the objective reach `target`, whatever the window: it is less
    /// than `target` only where width < this. Not positive if no width will do. Rounded up.
    double useful_width(double target, double m0, double m1) const;

    /// The same for the height of a pose of this width. \pre the objective is not Tilt, which
    /// does not depend on the height alone.
    double useful_height(double target, double width) const;
};

/// How far the ranges of a pose may go.
struct RangeLimits {
    double width = 2 * std::numbers::pi;  ///< rad
    double far = std::numbers::pi;        ///< rad, of m0 or m1; at least `near`
    double near = std::numbers::pi;       ///< rad, of the other

    /// Of the axes of `limits`: the tilt of C,A ends at 180 degrees, R2 of A,B at 90.
    RangeLimits(RotaryFamily family, const RotaryLimits& limits);

    /// Whether the part can be turned so that m0 and m1 are within. Non-strict.
    bool hold(double m0, double m1) const
    {
        return std::max(m0, m1) <= far + turn_tolerance &&
               std::min(m0, m1) <= near + turn_tolerance;
    }

    double widest() const { return width + turn_tolerance; }  ///< for w, rad
    double farthest() const { return far + turn_tolerance; }  ///< for m0 and m1, rad
    double highest() const { return far + near + 2 * turn_tolerance; }  ///< for h, rad
};

/// Whether m0 or m1 may rise to beyond `level` at no cost and within the limits, where the
/// other one is at least `other`: then sets that go up to `level` only need not be looked at.
inline bool rises_freely(const PoseMeasure& measure, const RangeLimits& limits,
                         double level, double other)
{
    return measure.objective == SetupObjective::Tilt &&
           level < std::min(other, limits.near);
}

}  // namespace endmill
