// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_force.h"

#include <cmath>

#include "endmill/core/error.h"

namespace endmill {

CuttingForce mean_force(const CuttingCoefficients& coefficients,
                        const CuttingMaterial& material, const MillingTool& tool,
                        double feed_per_tooth_mm, Milling milling)
{
    require_sound(material);
    require_sound(tool);
    require(std::isfinite(feed_per_tooth_mm) && feed_per_tooth_mm >= 0,
            "mean_force: need a feed per tooth of 0 or more");
    constexpr double mm_per_m = 1000;
    const CuttingCoefficients& mean = coefficients;
    const double s = milling == Milling::Up ? 1 : -1;
    const double f = feed_per_tooth_mm;
    const double h = material.edge_thickness_mm;
    const double scale =
        tool.flutes * tool.radius * material.specific_resistance_n_per_mm2;
    return {scale * (f * (s * mean.I1 + material.r1 * mean.I2) +
                     h * (s * mean.I3 + material.r2 * mean.I4)),
            scale * (f * (material.r1 * mean.I1 - s * mean.I2) +
                     h * (material.r2 * mean.I3 - s * mean.I4)),
            scale * (f * material.r3 * mean.I5 + h * material.r4 * mean.I6),
            s * scale * tool.radius * (f * mean.I7 + h * mean.I8) / mm_per_m};
}

}  // namespace endmill
