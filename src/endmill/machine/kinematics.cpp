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

// What the part and the tool are turned by, against the bed.
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

// From the tip with all axes at zero to that with the tool turned.
Vec3 tip_shift(const Machine& machine, const Turns& turns, double tool_length)
{
    return (machine.pivot + tool_length) * (turns.tool.col(2) - Vec3::UnitZ());
}

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
