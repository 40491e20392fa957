// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// A cylinder around the axis of a tool: a part of the shank or of the holder.
struct ToolCylinder {
    double diameter;  ///< mm
    double from;      ///< mm above the tip, lower end
    double to;        ///< mm above the tip, upper end

    /// Whether both cylinders are equal.
    friend bool operator==(const ToolCylinder&, const ToolCylinder&) = default;
};

/// Limits of the loads on a cutter. A missing limit does not apply.
struct LoadLimits {
    std::optional<double> cutting_force_n = {};  ///< N, across the axis
    std::optional<double> thrust_n = {};         ///< N, along the axis
    std::optional<double> torque_n_m = {};       ///< N m, about the axis

    /// Whether both have the same limits.
    friend bool operator==(const LoadLimits&, const LoadLimits&) = default;
};

/// A cutter with its shank, its holder and its properties, as a tool file describes it.
struct Tool {
    Cutter cutter;                    ///< the shape that cuts
    std::string name = {};            ///< for reports; may be empty
    std::optional<int> flutes = {};   ///< number of flutes, if known
    std::optional<Angle> helix = {};  ///< helix angle between flutes and axis, if known
    double length = 0;                ///< mm, from the tip to the spindle nose
    /// mm, from the tip to the upper end of the cutting edges; infinite if it is not known.
    double cutting_length = std::numeric_limits<double>::infinity();
    LoadLimits limits = {};                 ///< largest loads, if known
    std::vector<ToolCylinder> shank = {};   ///< cylinders between cutter and holder
    std::vector<ToolCylinder> holder = {};  ///< cylinders of the tool holder
};

/// Checks a tool.
/// \throws DomainError unless lengths are finite, diameters and limits are positive,
///         every cylinder has 0 <= from < to, the length is not negative, the cutting length
///         is positive and at least the corner radius, the number of
///         flutes is at least 1 if it is given, and the helix angle is below 90 degrees.
void require_sound(const Tool& tool);

/// The cylinders of shank and holder together: the parts that must not touch the
/// material.
std::vector<ToolCylinder> tool_body(const Tool& tool);

}  // namespace endmill
