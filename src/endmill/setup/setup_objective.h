// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <numbers>

#include "endmill/machine/configuration.h"
#include "endmill/setup/setup_pose.h"

/// \file
/// Objectives by which setups are compared.
///
/// All of them depend on two ranges, in rad: the width w of the window of the first
/// rotary axis (C in C,A, R1 in A,B), and the height h = m0 + m1 of the other axis. The
/// paper's area w h is not an objective, because it is 0 for every arc of a great circle,
/// however long.
/// Source: docs/mathematics/five-axis-setup.md, section 10.

namespace endmill {

/// The quantity that a setup minimises.
enum class SetupObjective : std::uint8_t {
    FlooredArea,  ///< (w + floor)(h + floor), rad^2
    TotalRange,   ///< w + h, rad
    Tilt          ///< largest turn, rad; C,A: max(m0, m1); A,B: max(w / 2, m0, m1)
};

/// The ranges of a pose in rad, none negative.
struct PoseRanges {
    double width = 0;  ///< w, range of C (C,A) or R1 (A,B)
    double m0 = 0;     ///< C,A: largest polar angle in the window; A,B: largest latitude
    double m1 =
        0;  ///< C,A: the same opposite to the window; A,B: minus the least latitude

    double height() const { return m0 + m1; }  ///< h, rad
};

/// The ranges of a fitted pose as objectives take them.
/// \param family decides which of phi and theta is the window. \param fit any pose.
PoseRanges pose_ranges(RotaryFamily family, const FittedPose& fit);

/// Evaluates an objective. The value does not decrease when a range grows.
struct PoseMeasure {
    RotaryFamily family = RotaryFamily::CA;
    SetupObjective objective = SetupObjective::FlooredArea;
    double floor_rad = 5.9 * std::numbers::pi / 180;  ///< floor of FlooredArea, above 0

    /// The objective of these ranges: rad^2 for FlooredArea, else rad. Relative error
    /// below 1e-15.
    double operator()(const PoseRanges& ranges) const;

    /// A width such that the objective is less than `target` only for windows narrower
    /// than it. The result is rounded up; it is not positive if no width reaches the
    /// target.
    /// \param target rad^2 or rad, in the unit of the objective.
    /// \param m0, m1 the other ranges, rad.
    double useful_width(double target, double m0, double m1) const;

    /// A height such that the objective is less than `target` only for heights below it.
    /// \param target rad^2 or rad. \param width of the window, rad.
    /// \pre the objective is not Tilt, which is not a function of the height.
    double useful_height(double target, double width) const;
};

}  // namespace endmill
