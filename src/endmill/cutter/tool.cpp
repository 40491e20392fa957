// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/tool.h"

#include <cmath>
#include <numbers>

#include "endmill/core/error.h"

namespace endmill {
namespace {

bool is_positive(double value)
{
    return std::isfinite(value) && value > 0;
}

void require_sound(const std::vector<ToolCylinder>& cylinders)
{
    for (const ToolCylinder& cylinder : cylinders) {
        require(is_positive(cylinder.diameter), "Tool: need 0 < diameter of a cylinder");
        require(0 <= cylinder.from && cylinder.from < cylinder.to &&
                    std::isfinite(cylinder.to),
                "Tool: need 0 <= from < to of a cylinder");
    }
}

}  // namespace

void require_sound(const Tool& tool)
{
    require_sound(tool.shank);
    require_sound(tool.holder);
    require(std::isfinite(tool.length) && tool.length >= 0, "Tool: need 0 <= length");
    require(tool.cutting_length > 0 && tool.cutting_length >= tool.cutter.corner_radius(),
            "Tool: need 0 < cutting length and corner radius <= cutting length");
    require(!tool.flutes || *tool.flutes >= 1, "Tool: need a flute");
    require(!tool.helix || std::abs(tool.helix->radians()) < std::numbers::pi / 2,
            "Tool: need a helix within 90 degrees");
    for (const auto& limit :
         {tool.limits.cutting_force_n, tool.limits.thrust_n, tool.limits.torque_n_m})
        require(!limit || is_positive(*limit), "Tool: need 0 < limit");
}

std::vector<ToolCylinder> tool_body(const Tool& tool)
{
    std::vector<ToolCylinder> body = tool.shank;
    body.insert(body.end(), tool.holder.begin(), tool.holder.end());
    return body;
}

}  // namespace endmill
