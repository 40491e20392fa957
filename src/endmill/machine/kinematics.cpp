// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/kinematics.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

using Matrix = Eigen::Matrix3d;

constexpr double pi = std::numbers::pi;

Vec3 axis_of(char letter)
{
    return Vec3::Unit(letter - 'a');
}

// Components of a direction from which its angles follow: along the tool axis, and along
// the two vectors of Across.
struct Components {
    double along;
    double first;
    double second;
};

// Two unit vectors perpendicular to the tool axis: r1 x C and r2 x C in A,B, the
// directions of the azimuths 0 and 90 degrees in C,A.
struct Across {
    Vec3 first;
    Vec3 second;
};

Across across(const RotaryFrame& frame)
{
    const Vec3 tilted = frame.r2_axis.cross(frame.tool_axis);
    if (frame.family == RotaryFamily::CA)
        return {tilted, frame.tool_axis.cross(tilted)};
    return {frame.r1_axis.cross(frame.tool_axis), tilted};
}

Components components(const RotaryFrame& frame, const Vec3& direction)
{
    const Across axes = across(frame);
    return {direction.dot(frame.tool_axis), direction.dot(axes.first),
            direction.dot(axes.second)};
}

// Shifts an angle within [-2 pi, 2 pi] by a whole turn into [-pi, pi].
double wrapped(double angle)
{
    if (angle > pi)
        return angle - 2 * pi;
    return angle < -pi ? angle + 2 * pi : angle;
}

// Rotations of part and tool against the bed.
struct Turns {
    Matrix part = Matrix::Identity();
    Matrix tool = Matrix::Identity();
};

Turns turns_at(const MachineConfiguration& configuration,
               const RotaryPositions& positions)
{
    Turns turns;
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k) {
        const RotaryAxis& axis = configuration.rotary[k];
        const Vec3 line = Vec3::Unit(axis.letter - 'a');
        const Matrix turn = Eigen::AngleAxisd{positions[k], line}.toRotationMatrix();
        // The axis nearest to the bed carries the others, so its turn comes first.
        if (axis.side == MachineSide::Table)
            turns.part = turn * turns.part;
        else
            turns.tool = turns.tool * turn;
    }
    return turns;
}

// Displacement of the tip by the turns of the tool.
Vec3 tip_shift(const Machine& machine, const Turns& turns, double tool_length)
{
    return (machine.pivot + tool_length) * (turns.tool.col(2) - Vec3::UnitZ());
}

// The solution with these turns, shifted by whole turns into the limits where that is
// possible.
RotarySolution solution(const Machine& machine, const RotaryAngles& angles)
{
    const MachineConfiguration& configuration = machine.configuration;
    const std::optional<double> phi = turn_within(machine.rotary.phi, angles.phi);
    const std::optional<double> theta = turn_within(machine.rotary.theta, angles.theta);
    const RotaryLimits turns{.phi = {phi.value_or(angles.phi), 0},
                             .theta = {theta.value_or(angles.theta), 0}};
    RotarySolution found{.angles = {turns.phi.from, turns.theta.from},
                         .positions = {0, 0},
                         .is_within_limits = phi && theta};
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k)
        found.positions[k] = mirrored(configuration.rotary[k].side,
                                      turns_of(turns, configuration, k).from);
    return found;
}

}  // namespace

RotaryFrame machine_frame(const MachineConfiguration& configuration)
{
    require(configuration.is_valid(),
            "machine_frame: need a configuration whose rotary axes all tilt the tool");
    const auto& rotary = configuration.rotary;
    if (rotary.size() == 2)
        return {configuration.family.value(), Vec3::UnitZ(), axis_of(rotary[0].letter),
                axis_of(rotary[1].letter)};
    const char only = rotary.empty() ? 'a' : rotary[0].letter;
    return {RotaryFamily::AB, Vec3::UnitZ(), axis_of(only),
            axis_of(only == 'a' ? 'b' : 'a')};
}

Vec3 turned_tool_axis(const RotaryFrame& frame, const RotaryAngles& angles)
{
    const Across axes = across(frame);
    const double phi = angles.phi;
    const double theta = angles.theta;
    if (frame.family == RotaryFamily::CA)
        return std::cos(phi) * frame.tool_axis +
               std::sin(phi) *
                   (std::cos(theta) * axes.first + std::sin(theta) * axes.second);
    return std::cos(theta) *
               (std::cos(phi) * frame.tool_axis + std::sin(phi) * axes.first) +
           std::sin(theta) * axes.second;
}

RotaryAngles rotary_angles(const RotaryFrame& frame, const Vec3& direction)
{
    const Components v = components(frame, direction);
    if (frame.family == RotaryFamily::CA)
        return {std::atan2(std::hypot(v.first, v.second), v.along),
                std::atan2(v.second, v.first)};
    // The arc tangent is accurate close to R1, where an arc sine would lose half of the
    // digits.
    return {std::atan2(v.first, v.along),
            std::atan2(v.second, std::hypot(v.first, v.along))};
}

RotaryAngles other_rotary_angles(RotaryFamily family, const RotaryAngles& angles)
{
    if (family == RotaryFamily::CA)
        return {-angles.phi, wrapped(angles.theta + (angles.theta > 0 ? -pi : pi))};
    return {wrapped(angles.phi + (angles.phi > 0 ? -pi : pi)),
            wrapped((angles.theta < 0 ? -pi : pi) - angles.theta)};
}

double distance_from_singular(const RotaryFrame& frame, const Vec3& direction)
{
    const Components v = components(frame, direction);
    return frame.family == RotaryFamily::CA ? std::hypot(v.first, v.second)
                                            : std::hypot(v.first, v.along);
}

AxisPositions axis_positions(const Machine& machine, const RotaryPositions& rotary,
                             const Vec3& point, double tool_length)
{
    const Turns turns = turns_at(machine.configuration, rotary);
    const Vec3& o = machine.table_offset;
    return {rotary,
            o + turns.part * (point - o) + tip_shift(machine, turns, tool_length)};
}

CutterLocation tool_location(const Machine& machine, const AxisPositions& positions,
                             double tool_length)
{
    const Turns turns = turns_at(machine.configuration, positions.rotary);
    const Vec3& o = machine.table_offset;
    const Vec3 turned = positions.xyz - o - tip_shift(machine, turns, tool_length);
    return {.tip = o + turns.part.transpose() * turned,
            .axis = turns.part.transpose() * turns.tool.col(2)};
}

bool is_within_travel(const Machine& machine, const AxisPositions& positions)
{
    const MachineConfiguration& configuration = machine.configuration;
    for (std::size_t k = 0; k < configuration.rotary.size(); ++k) {
        if (const auto& wide = machine.wide_positions[k]) {
            if (!(wide->from - turn_tolerance <= positions.rotary[k] &&
                  positions.rotary[k] <= wide->to + turn_tolerance))
                return false;
            continue;
        }
        const RotaryRange& range = turns_of(machine.rotary, configuration, k);
        const double turn = mirrored(configuration.rotary[k].side, positions.rotary[k]);
        const bool is_round =
            range.to - range.from >= 2 * std::numbers::pi - turn_tolerance;
        if (!is_round &&
            !(range.from - turn_tolerance <= turn && turn <= range.to + turn_tolerance))
            return false;
    }
    return is_within(machine.linear, positions.xyz);
}

std::vector<RotarySolution> rotary_solutions(const Machine& machine,
                                             const Vec3& direction)
{
    const double length = direction.stableNorm();
    require(std::isfinite(length) && length > 0,
            "rotary_solutions: need a direction that is finite and not zero");
    const RotaryFrame frame = machine_frame(machine.configuration);
    const Vec3 unit = direction.stableNormalized();
    RotaryAngles angles = rotary_angles(frame, unit);
    if (distance_from_singular(frame, unit) <= turn_tolerance)
        (frame.family == RotaryFamily::CA ? angles.theta : angles.phi) = 0;
    if (machine.configuration.rotary.size() == 2)
        return {solution(machine, angles),
                solution(machine, other_rotary_angles(frame.family, angles))};
    const bool is_on_arc = std::abs(angles.theta) <= turn_tolerance;
    const bool is_pole = is_on_arc && std::abs(angles.phi) <= turn_tolerance;
    if (!is_on_arc || (machine.configuration.rotary.empty() && !is_pole))
        return {};
    return {solution(machine, {angles.phi, 0})};
}

}  // namespace endmill
