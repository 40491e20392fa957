// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

#include <Eigen/Geometry>

#include "endmill/figures/setup_figures.h"

// Setups with known axes and ranges.
namespace endmill::test {

inline double rad(double degrees)
{
    return degrees * std::numbers::pi / 180;
}

inline RotaryRange range_deg(double from, double to)
{
    return {rad(from), rad(to)};
}

/// A rotation about a general axis.
inline Eigen::Matrix3d some_turn()
{
    return (Eigen::AngleAxisd{0.7, Vec3{1, 2, -1}.normalized()} *
            Eigen::AngleAxisd{-1.1, Vec3::UnitY()})
        .toRotationMatrix();
}

/// The axes of a machine with the configuration ca or ab.
inline RotaryFrame axes_of_machine(RotaryFamily family)
{
    if (family == RotaryFamily::CA)
        return {family, Vec3::UnitZ(), Vec3::UnitZ(), Vec3::UnitX()};
    return {family, Vec3::UnitZ(), Vec3::UnitX(), Vec3::UnitY()};
}

/// The setup of a part that `turn` rotates so that its axes become the machine's.
inline ShownSetup setup_turned(RotaryFamily family, const Eigen::Matrix3d& turn,
                               const RotaryLimits& needed)
{
    const RotaryFrame machine = axes_of_machine(family);
    const Eigen::Matrix3d back = turn.transpose();
    return {turn,
            {family, back * machine.tool_axis, back * machine.r1_axis,
             back * machine.r2_axis},
            needed,
            {}};
}

}  // namespace endmill::test
