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
// Turn in rad up to which the third derivative is smaller than the second.
constexpr double largest_refined_turn = 1;

bool is_unit(const Vec3& axis)
{
    return std::abs(axis.norm() - 1) <= axis_length_tolerance;
}

Eigen::Matrix3d rotation(const Vec3& axis, double angle)
{
    return Eigen::AngleAxisd{angle, axis}.toRotationMatrix();
}

// The rotation of a rotary axis of a machine.
Eigen::Matrix3d axis_rotation(const RotaryAxis& axis, double position)
{
    return rotation(Vec3::Unit(axis.letter - 'a'), position);
}

// The frame of the tool in the part at positions of the axes.
ToolFrame machine_frame_at(const PartOnMachine& setup, const AxisPositions& positions)
{
    Eigen::Matrix3d axes = setup.part_to_machine.transpose();
    const auto& rotary = setup.machine.configuration.rotary;
    // From the part to the tool: the axes of the part's side turn the part the other way.
    for (std::size_t k = 0; k < rotary.size(); ++k) {
        const bool is_table = rotary[k].side == MachineSide::Table;
        const double turn = is_table ? -positions.rotary[k] : positions.rotary[k];
        axes = axes * axis_rotation(rotary[k], turn);
    }
    return {tool_location(setup, positions).tip, axes};
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

AxisPositions ToolMotion::MachineMove::at(double u) const
{
    AxisPositions positions{from.rotary, (1 - u) * from.xyz + u * to.xyz};
    for (std::size_t k = 0; k < positions.rotary.size(); ++k)
        positions.rotary[k] = (1 - u) * from.rotary[k] + u * to.rotary[k];
    return positions;
}

ToolMotion::ToolMotion(const PartOnMachine& setup, Interpolation interpolation,
                       const AxisPositions& from, const AxisPositions& to)
    : from_{machine_frame_at(setup, from)},
      to_{machine_frame_at(setup, to)},
      turn_axis_{Vec3::UnitX()},
      turn_{0},
      travel_{(to_.tip - from_.tip).norm()},
      machine_{MachineMove{&setup, interpolation, from, to, 0, 0, 0}}
{
    require(interpolation != Interpolation::Linear,
            "ToolMotion: need Tcp or Joint for a machine");
    require(from_.tip.allFinite() && to_.tip.allFinite() && from_.axes.allFinite() &&
                to_.axes.allFinite(),
            "ToolMotion: a position is not finite");
    take_turns();
}

// Sets the turns of a motion of a machine.
void ToolMotion::take_turns()
{
    MachineMove& move = *machine_;
    move.part_turn = move.tool_turn = 0;
    const auto& rotary = move.setup->machine.configuration.rotary;
    for (std::size_t k = 0; k < rotary.size(); ++k)
        (rotary[k].side == MachineSide::Table ? move.part_turn : move.tool_turn) +=
            std::abs(move.to.rotary[k] - move.from.rotary[k]);
    move.way = (move.to.xyz - move.from.xyz).norm();
    turn_ = move.part_turn + move.tool_turn;
}

ToolFrame ToolMotion::at(double u) const
{
    const Vec3 tip = (1 - u) * from_.tip + u * to_.tip;
    if (machine_) {
        ToolFrame frame = machine_frame_at(*machine_->setup, machine_->at(u));
        if (machine_->interpolation == Interpolation::Tcp)
            frame.tip = tip;
        return frame;
    }
    if (turn_ == 0)
        return {tip, from_.axes};
    return {tip, rotation(turn_axis_, u * turn_) * from_.axes};
}

CutterLocation ToolMotion::location(double u) const
{
    const ToolFrame frame = at(u);
    return {frame.tip, frame.axes.col(2)};
}

// All bounds are convex in the point: sums of norms of what depends on it linearly.
double ToolMotion::chord_error(const Vec3& point) const
{
    if (turn_ == 0)
        return 0;
    if (machine_ && machine_->interpolation == Interpolation::Joint)
        return joint_bend(point) / 8;
    const double reach = std::sqrt(
        std::max((point - from_.tip).squaredNorm(), (point - to_.tip).squaredNorm()));
    return machine_ || turn_ > largest_refined_turn
               ? turn_ * (turn_ * reach + 2 * travel_) / 8
               : linear_error(point, reach);
}

// Seen from the tool, y = Q^T (x - t) with Q' = T [k] Q for the unit turn axis k. Hence
// y'' = Q^T (T^2 k x (k x (x - t)) + 2 T k x t').
double ToolMotion::linear_error(const Vec3& point, double reach) const
{
    const Vec3 way = to_.tip - from_.tip;
    const Vec3 turned = turn_axis_.cross(point - from_.tip - way / 2);
    const double at_middle =
        turn_ * (turn_ * turn_axis_.cross(turned) + 2 * turn_axis_.cross(way)).norm();
    const double change = turn_ * turn_ * (turn_ * reach + 3 * travel_);
    return (at_middle + change / 2) / 8;
}

// The point is carried by the axes of the part's side at a distance from their lines, and
// seen by those of the tool's side at a distance from theirs. The latter changes between the
// ends by at most half the way.
double ToolMotion::joint_bend(const Vec3& point) const
{
    const MachineMove& move = *machine_;
    const Machine& machine = move.setup->machine;
    const double a = move.part_turn;
    const double b = move.tool_turn;
    const double offset = machine.axis_offset.norm();
    const double carried =
        (clamped_point(*move.setup, point) - machine.table_offset).norm() + offset;
    const Vec3 arm = (machine.pivot + move.setup->tool_length) * Vec3::UnitZ();
    const double ends =
        std::max((from_.seen(point) - arm).norm(), (to_.seen(point) - arm).norm());
    const double seen = ends + (a * carried + move.way) / 2 + 4 * offset;
    return a * a * carried + b * b * seen + 2 * b * (a * carried + move.way);
}

double ToolMotion::largest_tool_bend(double far) const
{
    if (!machine_ || machine_->interpolation == Interpolation::Tcp)
        return turn_ * turn_ * far;
    const MachineMove& move = *machine_;
    const Machine& machine = move.setup->machine;
    const double a = move.part_turn;
    const double b = move.tool_turn;
    const double offset = machine.axis_offset.norm();
    const double arm = machine.pivot + move.setup->tool_length + offset + far;
    const auto from_table = [&](const AxisPositions& at) {
        return (tip_over_bed(*move.setup, at) - machine.table_offset).norm();
    };
    const double carried = std::max(from_table(move.from), from_table(move.to)) +
                           (move.way + arm * b) / 2 + offset + far;
    return a * a * carried + 2 * a * (move.way + arm * b) + arm * b * b;
}

std::array<ToolMotion, 2> ToolMotion::halves() const
{
    const ToolFrame middle = at(0.5);
    std::array halves{ToolMotion{from_, middle, turn_axis_, turn_ / 2},
                      ToolMotion{middle, to_, turn_axis_, turn_ / 2}};
    if (machine_) {
        const AxisPositions at_middle = machine_->at(0.5);
        for (ToolMotion& half : halves)
            half.machine_ = machine_;
        halves[0].machine_->to = at_middle;
        halves[1].machine_->from = at_middle;
        for (ToolMotion& half : halves)
            half.take_turns();
    }
    return halves;
}

}  // namespace endmill
