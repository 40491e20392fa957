// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "endmill/core/vec.h"
#include "endmill/cutter/detail/line_stretch.h"
#include "endmill/cutter/detail/sweep_entry.h"
#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// A line as the cutter of a move sees it from above: `along` the move and across it.
struct LineInPlan {
    double length;          ///< of the move over the xy plane, mm
    double rise;            ///< of the whole move, mm
    Eigen::Vector2d start;  ///< of the line, from the move's first tip, mm
    Eigen::Vector2d rate;   ///< of the line over the xy plane, per mm of it
    double start_z;         ///< of the line, above the move's first tip, mm
    double rate_z;          ///< per mm of the line
    Eigen::Vector2d along;  ///< the move's direction in x and y, unit
};

/// `line` seen from `sweep`.
LineInPlan line_in_plan(const StraightSweep& sweep, const Line& line);

/// The vector with these components along and across the move and upwards.
Vec3 out_of_plan(const LineInPlan& plan, double along, double across, double up);

/// Where the line is within the outline of the whole move, seen from above.
Stretch within_outline(const LineInPlan& plan, double radius);

/// Out of the outline, unit, at a t where the line crosses it.
Vec3 outline_normal(const LineInPlan& plan, double t);

}  // namespace endmill
