// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/rotary_angles.h"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>

#include "endmill/core/error.h"

namespace endmill {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 axis_of(char letter)
{
    return Vec3::Unit(letter - 'a');
}

// The direction in the frame in which the angles are read off: the tool axis, and across it
// r1 x C and r2 x C (A,B), or the azimuths 0 and 90 degrees (C,A).
struct Components {
    double along;
    double first;
    double second;
};

// Across the tool axis, as Components has them.
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

// An angle of [-2 pi, 2 pi] moved into [-pi, pi].
double wrapped(double angle)
{
    if (angle > pi)
        return angle - 2 * pi;
    return angle < -pi ? angle + 2 * pi : angle;
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
    // Not the arc sine, which loses half of the digits along R1.
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

}  // namespace endmill
