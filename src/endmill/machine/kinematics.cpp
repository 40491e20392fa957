// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/kinematics.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

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

// A vector that depends on the parameter of a motion, with its first two derivatives.
struct Jet {
    Vec3 value;
    Vec3 first = Vec3::Zero();
    Vec3 second = Vec3::Zero();
};

Jet moved(Jet jet, const Vec3& by)
{
    jet.value += by;
    return jet;
}

// A rotation about the line through the origin along an axis of the frame.
class AxisTurn {
public:
    AxisTurn(char letter, double angle)
        : axis_{letter - 'a'},
          cos_{std::cos(angle)},
          sin_{std::sin(angle)}
    {
    }

    Vec3 operator()(const Vec3& v) const { return turned(v, sin_); }
    Vec3 inverse(const Vec3& v) const { return turned(v, -sin_); }

    // With w = R x, w' = rate e x w + R x', and so on, for an angle with a constant rate.
    Jet operator()(const Jet& x, double rate) const { return turned(x, sin_, rate); }
    Jet inverse(const Jet& x, double rate) const { return turned(x, -sin_, -rate); }

private:
    Vec3 turned(const Vec3& v, double sine) const
    {
        const int j = (axis_ + 1) % 3;
        const int k = (axis_ + 2) % 3;
        Vec3 w = v;
        w[j] = cos_ * v[j] - sine * v[k];
        w[k] = sine * v[j] + cos_ * v[k];
        return w;
    }

    Jet turned(const Jet& x, double sine, double rate) const
    {
        const Vec3 value = turned(x.value, sine);
        const Vec3 first = turned(x.first, sine);
        const Vec3 turning = rate * Vec3::Unit(axis_).cross(value);
        return {value, first + turning,
                turned(x.second, sine) + 2 * rate * Vec3::Unit(axis_).cross(first) +
                    rate * Vec3::Unit(axis_).cross(turning)};
    }

    int axis_;
    double cos_;
    double sin_;
};

// The rotary axes of a machine at given positions, as two chains: from the part to the bed,
// and from the tool to the bed. An axis that the machine lacks is left out.
class AxisChains {
public:
    AxisChains(const Machine& machine, const RotaryPositions& positions,
               double tool_length)
        : table_offset_{machine.table_offset},
          axis_offset_{machine.axis_offset},
          arm_{machine.pivot + tool_length}
    {
        for (std::size_t k = 0; k < machine.configuration.rotary.size(); ++k) {
            const RotaryAxis& axis = machine.configuration.rotary[k];
            (axis.side == MachineSide::Table ? part_ : tool_)
                .add(k, AxisTurn{axis.letter, positions[k]});
        }
    }

    // P: the point of the part against the bed. A second axis is `axis_offset` from the
    // first one.
    Vec3 carried(const Vec3& point) const
    {
        Vec3 at = point - table_offset_;
        if (part_.count > 0)
            at = (*part_.turns[0])(at);
        if (part_.count > 1)
            at = (*part_.turns[1])(at - axis_offset_) + axis_offset_;
        return at + table_offset_;
    }

    // The inverse of `carried`.
    Jet in_part(const Jet& bed, const RotaryPositions& rates) const
    {
        Jet at = moved(bed, -table_offset_);
        if (part_.count > 1)
            at = moved(
                part_.turns[1]->inverse(moved(at, -axis_offset_), rates[part_.axes[1]]),
                axis_offset_);
        if (part_.count > 0)
            at = part_.turns[0]->inverse(at, rates[part_.axes[0]]);
        return moved(at, table_offset_);
    }

    Vec3 in_part(const Vec3& bed) const
    {
        Vec3 at = bed - table_offset_;
        if (part_.count > 1)
            at = part_.turns[1]->inverse(at - axis_offset_) + axis_offset_;
        if (part_.count > 0)
            at = part_.turns[0]->inverse(at);
        return at + table_offset_;
    }

    // D: displacement of the tip by the turns of the tool.
    Jet tip_shift(const RotaryPositions& rates) const
    {
        const Vec3 arm = arm_ * Vec3::UnitZ();
        if (tool_.count == 0)
            return {Vec3::Zero()};
        const std::size_t last = tool_.count - 1;
        Jet at = (*tool_.turns[last])(Jet{-arm}, rates[tool_.axes[last]]);
        if (tool_.count > 1)
            at = moved((*tool_.turns[0])(moved(at, axis_offset_), rates[tool_.axes[0]]),
                       -axis_offset_);
        return moved(at, arm);
    }

    Vec3 tip_shift() const
    {
        const Vec3 arm = arm_ * Vec3::UnitZ();
        if (tool_.count == 0)
            return Vec3::Zero();
        Vec3 at = (*tool_.turns[tool_.count - 1])(Vec3{-arm});
        if (tool_.count > 1)
            at = (*tool_.turns[0])(at + axis_offset_) - axis_offset_;
        return at + arm;
    }

    // The tool axis as the part sees it.
    Vec3 axis_in_part() const
    {
        Vec3 axis = Vec3::UnitZ();
        for (std::size_t k = tool_.count; k-- > 0;)
            axis = (*tool_.turns[k])(axis);
        for (std::size_t k = part_.count; k-- > 0;)
            axis = part_.turns[k]->inverse(axis);
        return axis;
    }

private:
    // Axes of one side, from the part towards the tool.
    struct Chain {
        void add(std::size_t axis, const AxisTurn& turn)
        {
            axes[count] = axis;
            turns[count++] = turn;
        }

        std::array<std::optional<AxisTurn>, 2> turns = {};
        std::array<std::size_t, 2> axes = {};  // among the rotary axes of the machine
        std::size_t count = 0;
    };

    Vec3 table_offset_;
    Vec3 axis_offset_;
    double arm_;
    Chain part_;
    Chain tool_;
};

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

RotaryRange position_range(const Machine& machine, std::size_t axis)
{
    if (const auto& wide = machine.wide_positions[axis])
        return *wide;
    const RotaryRange& turns = turns_of(machine.rotary, machine.configuration, axis);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (turns.to - turns.from >= 2 * pi - turn_tolerance)
        return {-infinity, infinity};
    return mirrored(machine.configuration.rotary[axis].side, turns);
}

AxisPositions axis_positions(const Machine& machine, const RotaryPositions& rotary,
                             const Vec3& point, double tool_length)
{
    const AxisChains chains{machine, rotary, tool_length};
    return {rotary, chains.carried(point) - chains.tip_shift()};
}

CutterLocation tool_location(const Machine& machine, const AxisPositions& positions,
                             double tool_length)
{
    const AxisChains chains{machine, positions.rotary, tool_length};
    return {.tip = chains.in_part(Vec3{positions.xyz + chains.tip_shift()}),
            .axis = chains.axis_in_part()};
}

bool is_within_travel(const Machine& machine, const AxisPositions& positions)
{
    for (std::size_t k = 0; k < machine.configuration.rotary.size(); ++k) {
        const RotaryRange range = position_range(machine, k);
        if (!(range.from - turn_tolerance <= positions.rotary[k] &&
              positions.rotary[k] <= range.to + turn_tolerance))
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

Vec3 clamped_point(const PartOnMachine& setup, const Vec3& point)
{
    return setup.part_to_machine * point + setup.clamp;
}

AxisPositions axis_positions(const PartOnMachine& setup, const RotaryPositions& rotary,
                             const Vec3& tip)
{
    return axis_positions(setup.machine, rotary, clamped_point(setup, tip),
                          setup.tool_length);
}

CutterLocation tool_location(const PartOnMachine& setup, const AxisPositions& positions)
{
    const CutterLocation seen =
        tool_location(setup.machine, positions, setup.tool_length);
    return {.tip = setup.part_to_machine.transpose() * (seen.tip - setup.clamp),
            .axis = setup.part_to_machine.transpose() * seen.axis};
}

Vec3 tip_over_bed(const PartOnMachine& setup, const AxisPositions& positions)
{
    return positions.xyz +
           AxisChains{setup.machine, positions.rotary, setup.tool_length}.tip_shift();
}

std::vector<RotarySolution> rotary_solutions(const PartOnMachine& setup,
                                             const Vec3& direction)
{
    return rotary_solutions(setup.machine, setup.part_to_machine * direction);
}

TipMotion tip_motion(const PartOnMachine& setup, const AxisPositions& at,
                     const AxisPositions& rates)
{
    const AxisChains chains{setup.machine, at.rotary, setup.tool_length};
    Jet bed = moved(chains.tip_shift(rates.rotary), at.xyz);
    bed.first += rates.xyz;
    const Jet tip = chains.in_part(bed, rates.rotary);
    const Eigen::Matrix3d to_part = setup.part_to_machine.transpose();
    return {.tip = to_part * (tip.value - setup.clamp),
            .velocity = to_part * tip.first,
            .acceleration = to_part * tip.second};
}

std::string_view interpolation_name(Interpolation interpolation)
{
    switch (interpolation) {
        case Interpolation::Linear:
            return "linear";
        case Interpolation::Tcp:
            return "tcp";
        case Interpolation::Joint:
            return "joint";
    }
    return {};
}

std::optional<Interpolation> interpolation_from_name(std::string_view name)
{
    for (const Interpolation interpolation :
         {Interpolation::Linear, Interpolation::Tcp, Interpolation::Joint})
        if (interpolation_name(interpolation) == name)
            return interpolation;
    return std::nullopt;
}

double angle_between(const Vec3& first, const Vec3& second)
{
    return 2 * std::atan2((first - second).norm(), (first + second).norm());
}

Vec3 axis_on_arc(const Vec3& from, const Vec3& to, double u)
{
    const double angle = angle_between(from, to);
    const double sine = std::sin(angle);
    // Below this angle the chord and the arc differ by less than rounding.
    constexpr double least_angle = 1e-8;
    if (angle < least_angle)
        return ((1 - u) * from + u * to).normalized();
    return ((std::sin((1 - u) * angle) / sine) * from + (std::sin(u * angle) / sine) * to)
        .normalized();
}

}  // namespace endmill
