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

}  // namespace endmill
