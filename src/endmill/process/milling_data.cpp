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

void require_sound(const CuttingMaterial& material)
{
    require(is_positive(material.specific_resistance_n_per_mm2),
            "CuttingMaterial: need 0 < specific resistance");
    require(std::isfinite(material.edge_thickness_mm) && material.edge_thickness_mm >= 0,
            "CuttingMaterial: need 0 <= edge thickness");
    for (const double ratio : {material.r1, material.r2, material.r3, material.r4})
        require(std::isfinite(ratio) && ratio >= 0,
                "CuttingMaterial: need 0 <= r1, r2, r3, r4");
    require(material.alpha > 0 && material.alpha < 1,
            "CuttingMaterial: need 0 < alpha < 1");
    require(is_positive(material.v1_m_per_min), "CuttingMaterial: need 0 < v1");
    for (const auto& feed :
         {material.max_feed_per_tooth_mm, material.min_feed_per_tooth_mm})
        require(!feed || is_positive(*feed), "CuttingMaterial: need 0 < feed per tooth");
    require(!material.max_feed_per_tooth_mm || !material.min_feed_per_tooth_mm ||
                *material.min_feed_per_tooth_mm <= *material.max_feed_per_tooth_mm,
            "CuttingMaterial: need least feed per tooth <= largest");
}

void require_sound(const MillingTool& tool)
{
    require(is_positive(tool.radius), "MillingTool: need 0 < radius");
    require(tool.flutes >= 1, "MillingTool: need a flute");
    require(std::abs(tool.helix) <= most_helix,
            "MillingTool: need a helix within 80 degrees");
    for (const auto& limit :
         {tool.limits.cutting_force_n, tool.limits.thrust_n, tool.limits.torque_n_m})
        require(!limit || is_positive(*limit), "MillingTool: need 0 < limit");
}

MillingTool milling_tool(const Tool& tool)
{
    require_sound(tool);
    if (!tool.cutter.is_ball())
        throw DomainError{"milling_tool: expected a ball-end mill; found " +
                          cutter_word(tool.cutter)};
    require(tool.flutes.has_value(), "milling_tool: need the number of flutes");
    const MillingTool seen{.radius = tool.cutter.radius(),
                           .flutes = *tool.flutes,
                           .helix = tool.helix ? tool.helix->radians() : 0,
                           .limits = tool.limits};
    require_sound(seen);
    return seen;
}

void require_sound(const MachineLimits& machine)
{
    for (const auto& limit :
         {machine.max_rpm, machine.max_power_w, machine.max_torque_n_m,
          machine.max_feed_mm_per_min, machine.acceleration_m_per_s2})
        require(!limit || (std::isfinite(*limit) && *limit > 0),
                "MachineLimits: need 0 < limit");
}

}  // namespace endmill
