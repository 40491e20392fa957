// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/milling_data.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {
namespace {

bool is_positive(double value)
{
    return std::isfinite(value) && value > 0;
}

}  // namespace

void require_sound(const MillingTool& tool)
{
    require(is_positive(tool.radius), "MillingTool: need 0 < radius");
    require(tool.flutes >= 1, "MillingTool: need a flute");
    require(std::abs(tool.helix) <= most_helix,
            "MillingTool: need a helix within 80 degrees");
    for (const auto& limit : {tool.cutting_force_n, tool.thrust_n, tool.torque_n_m})
        require(!limit || is_positive(*limit), "MillingTool: need 0 < limit");
}

MillingTool milling_tool(const Tool& tool)
{
    require_sound(tool);
    if (!tool.cutter.is_ball())
        throw DomainError{"milling_tool: the model is of ball-end mills; found " +
                          cutter_word(tool.cutter)};
    require(tool.flutes.has_value(), "milling_tool: need the number of flutes");
    const MillingTool seen{.radius = tool.cutter.radius(),
                           .flutes = *tool.flutes,
                           .helix = tool.helix ? tool.helix->radians() : 0,
                           .cutting_force_n = tool.limits.cutting_force,
                           .thrust_n = tool.limits.thrust,
                           .torque_n_m = tool.limits.torque};
    require_sound(seen);
    return seen;
}

}  // namespace endmill
