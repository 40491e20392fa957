// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/tool_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/core/error.h"
#include "endmill/core/tolerance.h"

namespace endmill {
namespace {

// Least angle in rad that two axes must differ from opposite directions. Nearer to them
// the arc between them depends on the rounding of the axes.
constexpr double least_from_opposite = 1e-3;

bool is_unit(const Vec3& axis)
{
    return std::abs(axis.norm() - 1) <= axis_length_tolerance;
}

Eigen::Matrix3d rotation(const Vec3& axis, double angle)
{
    return Eigen::AngleAxisd{angle, axis}.toRotationMatrix();
}

}  // namespace

ToolFrame frame_at(const CutterLocation& location)
{
    const Vec3& z = location.axis;
    ToolFrame frame{location.tip, {}};
    const Vec3 x = z.unitOrthogonal();
    frame.axes << x, z.cross(x), z;
    return frame;
}

ToolMotion::ToolMotion(const CutterLocation& from, const CutterLocation& to)
    : from_{frame_at({from.tip, from.axis.normalized()})},
      to_{to.tip, from_.axes},
      turn_axis_{Vec3::UnitX()},
      turn_{0},
      travel_{(to.tip - from.tip).norm()}
{
    require(from.tip.allFinite() && to.tip.allFinite(),
            "ToolMotion: a tip is not finite");
    require(is_unit(from.axis) && is_unit(to.axis),
            "ToolMotion: need axes that are unit vectors");
    const Vec3 first = from.axis.normalized();
    const Vec3 last = to.axis.normalized();
    const Vec3 across = first.cross(last);
    const double sine = across.norm();
    if (from.axis == to.axis || !(sine > 0)) {
        require(first.dot(last) > 0, "ToolMotion: the axes are opposite");
        return;
    }
    turn_ = std::atan2(sine, first.dot(last));
    require(turn_ <= std::numbers::pi - least_from_opposite,
            "ToolMotion: the axes are opposite");
    turn_axis_ = across / sine;
    to_.axes = rotation(turn_axis_, turn_) * from_.axes;
}

ToolMotion::ToolMotion(const ToolFrame& from, const ToolFrame& to, const Vec3& turn_axis,
                       double turn)
    : from_{from},
      to_{to},
      turn_axis_{turn_axis},
      turn_{turn},
      travel_{(to.tip - from.tip).norm()}
{
}

ToolFrame ToolMotion::at(double u) const
{
    const Vec3 tip = (1 - u) * from_.tip + u * to_.tip;
    if (turn_ == 0)
        return {tip, from_.axes};
    return {tip, rotation(turn_axis_, u * turn_) * from_.axes};
}

CutterLocation ToolMotion::location(double u) const
{
    const ToolFrame frame = at(u);
    return {frame.tip, frame.axes.col(2)};
}

// Seen from the tool, y = Q^T (x - t) with Q' = T [k] Q for the unit turn axis k. Hence
// y'' = Q^T (T^2 k x (k x (x - t)) + 2 T k x t').
double ToolMotion::chord_error(const Vec3& point) const
{
    if (turn_ == 0)
        return 0;
    const Vec3 way = to_.tip - from_.tip;
    const Vec3 from = point - from_.tip;
    const double reach =
        std::sqrt(std::max(from.squaredNorm(), (point - to_.tip).squaredNorm()));
    const double bend = largest_bend(reach);
    const Vec3 turned = turn_axis_.cross(from - way / 2);
    const double at_middle =
        turn_ * (turn_ * turn_axis_.cross(turned) + 2 * turn_axis_.cross(way)).norm();
    const double change = turn_ * turn_ * (turn_ * reach + 3 * travel_);
    return std::min(bend, at_middle + change / 2) / 8;
}

std::array<ToolMotion, 2> ToolMotion::halves() const
{
    const ToolFrame middle = at(0.5);
    return {ToolMotion{from_, middle, turn_axis_, turn_ / 2},
            ToolMotion{middle, to_, turn_axis_, turn_ / 2}};
}

}  // namespace endmill
