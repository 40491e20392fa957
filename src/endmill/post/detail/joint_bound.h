// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/machine/kinematics.h"

namespace endmill {

/// Bounds of the derivatives of the tip's motion in the part while all axes move evenly
/// from one position to another, with respect to the parameter from 0 to 1.
struct JointBound {
    double second = 0;       ///< mm, largest second derivative of the tip
    double third = 0;        ///< mm, largest third derivative of the tip
    double rotary_turn = 0;  ///< rad, sum of the turns of all rotary axes

    /// mm, largest distance at equal parameters between the tip and a point that moves
    /// evenly on the straight line between its ends.
    /// \param middle mm, second derivative of the tip at the middle of the motion.
    double tip_error(double middle) const;

    /// rad, largest angle at equal parameters between the tool axis and an axis that turns
    /// evenly on the great arc between its ends.
    /// \param angle rad, between the axes at both ends.
    double axis_error(double angle) const;
};

/// The bounds for the motion from `from` to `to`.
///
/// With a, b the sums of the turns of the axes on the part's and the tool's side, d the
/// length of the way of X, Y, Z, L the distance from the tool's rotary axes to the tip, and
/// r at least the distance of the tip from the table's centre,
///
///     |p''| <= a^2 r + 2 a (d + L b) + L b^2,
///     |p'''| <= a^3 r + 3 a^2 (d + L b) + 3 a L b^2 + L b^3.
///
/// An offset between two axes adds its length to r and L.
/// Source: docs/methods/five-axis-paths.md, section 3.
JointBound joint_bound(const PartOnMachine& setup, const AxisPositions& from,
                       const AxisPositions& to);

/// mm, length of the second derivative of the tip at the middle of the motion.
double middle_acceleration(const PartOnMachine& setup, const AxisPositions& from,
                           const AxisPositions& to);

}  // namespace endmill
