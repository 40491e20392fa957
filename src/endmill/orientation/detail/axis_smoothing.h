// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "endmill/core/vec.h"
#include "endmill/machine/kinematics.h"

namespace endmill {

/// A row whose axis may be moved.
struct SmoothedRow {
    Vec3 axis;                 ///< unit
    double way_mm;             ///< along the path from its start; it never decreases
    bool starts_pass = false;  ///< the turn before it is not limited
};

/// Limits of smoothing.
struct SmoothingLimits {
    /// Whether a row may take an axis. It is called by several threads at once.
    std::function<bool(std::size_t row, const Vec3& axis)> is_allowed;
    double greatest_turn = 0;  ///< rad, between rows of a pass that turned less before
    int rounds = 0;            ///< greatest number
    /// If set, the rotary axes of this machine are smoothed, else the direction.
    const PartOnMachine* machine = nullptr;
};

/// Smoothed axes and the sum that was lowered.
struct SmoothedAxes {
    std::vector<Vec3> axes;  ///< unit, one for each row
    double rough_bend = 0;   ///< the sum before; rad^2/mm
    double smooth_bend = 0;  ///< the sum after; never above `rough_bend`
    int rounds = 0;          ///< rounds that were needed
};

/// Lowers the sum of |q_(i+1) - q_i|^2 / (s_(i+1) - s_i) over all rows, where q is the axis, or
/// the positions of the rotary axes of a machine, and s the way. Rows of even numbers and rows
/// of odd numbers move in turn. The least sum for fixed neighbours is at their mean, weighted
/// by the inverse ways; a row moves there, or half as far until it is allowed. A row that is
/// allowed at first stays allowed. The result does not depend on the number of threads.
/// Source: docs/methods/five-axis-planning.md, section 5.
SmoothedAxes smooth_axes(std::span<const SmoothedRow> rows,
                         const SmoothingLimits& limits);

}  // namespace endmill
