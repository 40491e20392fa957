// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"

/// \file
/// The motion of a tool between two poses, and how the points of the part move as seen
/// from the tool. All motions are described over a parameter u from 0 to 1.

namespace endmill {

/// A place of the tool with a frame that is fixed to it.
struct ToolFrame {
    Vec3 tip;              ///< mm, in the part
    Eigen::Matrix3d axes;  ///< columns: the tool's x, y and z (its axis) in the part

    /// Returns a place of the part as seen from the tool: the tip is the origin.
    Vec3 seen(const Vec3& point) const { return axes.transpose() * (point - tip); }
};

/// Returns a frame at a location. Its turn about the tool axis is any.
/// \pre the axis is a unit vector.
ToolFrame frame_at(const CutterLocation& location);

/// A linear motion: the tip moves straight and evenly, the tool axis moves evenly on the
/// great arc from the first direction to the second. Between them the frame turns about
/// the normal of the arc, so that it does not turn about the tool axis. An immutable value.
///
/// A point x of the part moves along a curve y(u) as seen from the tool. It differs from
/// the straight line from y(0) to y(1) by at most max|y''| / 8. With the angle T of the
/// arc, the way D of the tip and X, the larger distance of x from the tip at an end,
///
///     |y''| <= T^2 X + 2 T D,    |y'''| <= T^3 X + 3 T^2 D.
///
/// Source: docs/methods/five-axis-removal.md, section 2.
class ToolMotion {
public:
    /// \throws DomainError if a coordinate is not finite, an axis is not a unit vector, or
    ///         the two axes are opposite within 1e-3 rad.
    ToolMotion(const CutterLocation& from, const CutterLocation& to);

    const ToolFrame& from() const { return from_; }  ///< at u = 0
    const ToolFrame& to() const { return to_; }      ///< at u = 1

    /// Angle by which the tool turns, rad.
    double turn() const { return turn_; }

    /// Returns the frame at u.
    ToolFrame at(double u) const;

    /// Returns tip and axis at u.
    CutterLocation location(double u) const;

    /// Returns y(u), a place of the part as seen from the tool.
    Vec3 seen(const Vec3& point, double u) const { return at(u).seen(point); }

    /// Returns an upper bound of the distance in mm between y(u) and the straight line
    /// from y(0) to y(1) at the same u: the smaller of max|y''| / 8 and
    /// (|y''(1/2)| + max|y'''| / 2) / 8.
    double chord_error(const Vec3& point) const;

    /// Returns an upper bound of |y''| for all places within `reach` mm of both tips.
    double largest_bend(double reach) const
    {
        return turn_ * (turn_ * reach + 2 * travel_);
    }

    /// Returns an upper bound of the second derivative, in the part, of the place that lies
    /// `height` mm above the tip on the axis.
    double largest_axis_bend(double height) const { return turn_ * turn_ * height; }

    /// Returns the two motions from u = 0 to 1/2 and from 1/2 to 1.
    std::array<ToolMotion, 2> halves() const;

private:
    ToolMotion(const ToolFrame& from, const ToolFrame& to, const Vec3& turn_axis,
               double turn);

    ToolFrame from_;
    ToolFrame to_;
    Vec3 turn_axis_;  // unit, in the part; any if the tool does not turn
    double turn_;
    double travel_;  // of the tip, mm
};

}  // namespace endmill
