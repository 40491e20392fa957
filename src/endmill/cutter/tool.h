// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "endmill/core/angle.h"
#include "endmill/cutter/cutter.h"

namespace endmill {

/// A cylinder around the axis of a tool.
struct ToolCylinder {
    double diameter;  ///< mm
    double from;      ///< mm above the tip
    double to;        ///< mm above the tip

    /// Whether both are the same cylinder.
    friend bool operator==(const ToolCylinder&, const ToolCylinder&) = default;
};

/// The most that a tool bears; none where nothing is said.
struct ToolLimits {
    std::optional<double> cutting_force;  ///< N
    std::optional<double> thrust;         ///< N
    std::optional<double> torque;         ///< N m

    /// Whether both say the same.
    friend bool operator==(const ToolLimits&, const ToolLimits&) = default;
};

/// A cutter with what holds it.
struct Tool {
    Cutter cutter;
    std::string name = {};
    std::optional<int> flutes = {};   ///< their number
    std::optional<Angle> helix = {};  ///< of the flutes against the axis
    double length = 0;                ///< mm, from the tip to the spindle nose
    ToolLimits limits = {};
    std::vector<ToolCylinder> shank = {};
    std::vector<ToolCylinder> holder = {};
};

/// \throws DomainError unless: lengths are finite, diameters and limits positive, every
///         cylinder has 0 <= from < to, the length is not negative, there is a flute if
///         any, and the helix is within 90 degrees.
void require_sound(const Tool& tool);

/// Shank and holder: what must not touch the material.
std::vector<ToolCylinder> tool_body(const Tool& tool);

}  // namespace endmill
