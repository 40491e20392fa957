// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <Eigen/Core>

#include "endmill/core/vec.h"
#include "endmill/cutter/cutter.h"
#include "endmill/machine/kinematics.h"

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

/// The motion of a tool by one of the interpolations. An immutable value.
///
/// - `Linear`: the tip moves straight and evenly, the axis evenly on the great arc. The frame
///   turns about the normal of the arc, so that it does not turn about the tool axis.
/// - `Tcp`: the tip moves straight and evenly, the positions of the rotary axes evenly.
/// - `Joint`: the positions of all axes of the machine change evenly.
///
/// A point x of the part moves along a curve y(u) as seen from the tool. It differs from
/// the straight line from y(0) to y(1) by at most max|y''| / 8. With the angle T of the arc,
/// for `Tcp` with the sum T of the turns of all rotary axes, the way D of the tip and X, the
/// larger distance of x from the tip at an end,
///
///     |y''| <= T^2 X + 2 T D,    |y'''| <= T^3 X + 3 T^2 D.
///
/// Source: docs/methods/five-axis-removal.md, section 2.
class ToolMotion {
public:
    /// A linear motion.
    /// \throws DomainError if a coordinate is not finite, an axis is not a unit vector, or
    ///         the two axes are opposite within 1e-3 rad.
    ToolMotion(const CutterLocation& from, const CutterLocation& to);

    /// A motion of a machine.
    /// \param setup must outlive the motion and its halves.
    /// \param interpolation Tcp or Joint.
    /// \throws DomainError for another interpolation, or positions that are not finite.
    ToolMotion(const PartOnMachine& setup, Interpolation interpolation,
               const AxisPositions& from, const AxisPositions& to);

    const ToolFrame& from() const { return from_; }  ///< at u = 0
    const ToolFrame& to() const { return to_; }      ///< at u = 1

    /// Angle by which the tool turns as seen from the part, at most; rad.
    double turn() const { return turn_; }

    /// Returns the frame at u.
    ToolFrame at(double u) const;

    /// Returns tip and axis at u.
    CutterLocation location(double u) const;

    /// Returns y(u), a place of the part as seen from the tool.
    Vec3 seen(const Vec3& point, double u) const { return at(u).seen(point); }

    /// Returns an upper bound of the distance in mm between y(u) and the straight line
    /// from y(0) to y(1) at the same u: max|y''| / 8, for a linear motion that turns by at
    /// most 1 rad (|y''(1/2)| + max|y'''| / 2) / 8. The bound is convex in the point, so
    /// that on a segment it is largest at an end.
    double chord_error(const Vec3& point) const;

    /// Returns an upper bound of the second derivative, in the part, of all places of the
    /// tool that lie within `far` mm of the tip.
    double largest_tool_bend(double far) const;

    /// Returns an upper bound of the distance between the axis at u and the same combination
    /// of the axes at the ends; 0 for a linear motion, whose axis lies between them.
    double axis_sag() const { return machine_ ? turn_ * turn_ / 8 : 0; }

    /// Returns the two motions from u = 0 to 1/2 and from 1/2 to 1.
    std::array<ToolMotion, 2> halves() const;

private:
    // A motion of a machine.
    struct MachineMove {
        const PartOnMachine* setup;
        Interpolation interpolation;
        AxisPositions from;
        AxisPositions to;
        double part_turn;  // rad, of the axes on the part's side
        double tool_turn;  // rad, of those on the tool's side
        double way;        // mm, of X, Y and Z

        AxisPositions at(double u) const;
    };

    ToolMotion(const ToolFrame& from, const ToolFrame& to, const Vec3& turn_axis,
               double turn);
    void take_turns();
    double linear_error(const Vec3& point, double reach) const;
    double joint_bend(const Vec3& point) const;

    ToolFrame from_;
    ToolFrame to_;
    Vec3 turn_axis_;  // unit, in the part; of a linear motion
    double turn_;
    double travel_;  // of the tip, mm
    std::optional<MachineMove> machine_ = {};
};

}  // namespace endmill
