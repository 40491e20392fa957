// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/cutter/straight_sweep.h"

namespace endmill {

/// \file
/// Lines in space, intervals of them, and a line seen in the frame of a move: what the
/// computation of `sweep_entry` is made of.

/// The points origin + t direction for all t.
struct Line {
    Vec3 origin;     ///< mm
    Vec3 direction;  ///< unit
};

/// Where a line enters the region that a move clears.
struct SweepEntry {
    /// Place on the line, in mm from its origin; minus infinity if all of the line before
    /// it is inside.
    double t;
    Vec3 normal;  ///< of the region's boundary at the entry, unit, out of the region
};

/// The interval low <= t <= high of a line's parameter; empty if low > high.
struct LineInterval {
    double low = -std::numeric_limits<double>::infinity();  ///< mm along the line
    double high = std::numeric_limits<double>::infinity();  ///< mm along the line

    bool is_empty() const { return !(low <= high); }  ///< also true if an end is NaN

    /// The empty interval.
    static LineInterval none()
    {
        return {std::numeric_limits<double>::infinity(),
                -std::numeric_limits<double>::infinity()};
    }
};

/// The interval that is in both.
LineInterval intersection(const LineInterval& a, const LineInterval& b);

/// The smallest interval that contains both. Empty intervals do not count.
LineInterval hull(const LineInterval& a, const LineInterval& b);

/// Where value + t rate >= 0.
LineInterval where_not_negative(double value, double rate);

/// Where |offset + t rate| <= radius: of a line in the plane and a circle, or of a line
/// in space and a cylinder. If the line touches the circle, rounding decides between an
/// interval of one point and the empty one.
LineInterval within_circle(const Eigen::Vector2d& offset, const Eigen::Vector2d& rate,
                           double radius);

/// A line in the frame of a move: one axis along the move over the xy plane, the second
/// across it to the left, the third upwards, with the move's first tip as origin.
struct LineInPlan {
    double length;          ///< of the move over the xy plane, mm
    double rise;            ///< of the whole move, mm
    Eigen::Vector2d start;  ///< line's origin: along and across the move, mm
    Eigen::Vector2d rate;   ///< line's direction: along and across the move
    double start_z;         ///< line's origin above the first tip, mm
    double rate_z;          ///< line's direction: upwards
    Eigen::Vector2d along;  ///< direction of the move over the xy plane, unit
};

/// The line in the frame of the move of `sweep`.
LineInPlan line_in_plan(const StraightSweep& sweep, const Line& line);

/// The vector of space with these components in the frame of the move.
Vec3 out_of_plan(const LineInPlan& plan, double along, double across, double up);

/// Where the line is within the outline of the whole move, seen from above: within
/// `radius` of the segment between the two tips.
LineInterval within_outline(const LineInPlan& plan, double radius);

/// Normal of the outline, unit and outwards, at a place t where the line crosses it.
Vec3 outline_normal(const LineInPlan& plan, double t);

}  // namespace endmill
