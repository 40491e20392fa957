// SPDX-License-Identifier: GPL-3.0-or-later
#include "five-axis-setup/equations/random_sets.h"

#include <cmath>
#include <numbers>

#include "endmill/core/angle.h"

namespace endmill {

double RandomSets::number(double low, double high)
{
    // 53 bits: std::uniform_real_distribution differs between libraries.
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
}

std::vector<Vec3> RandomSets::directions()
{
    const double farthest = Angle::degrees(85).radians();
    std::vector<Vec3> found(static_cast<std::size_t>(number(3, 33)));
    for (Vec3& direction : found) {
        const double azimuth = number(0, 2 * std::numbers::pi);
        const double polar = farthest * std::sqrt(number(0, 1));
        direction = {std::sin(polar) * std::cos(azimuth),
                     std::sin(polar) * std::sin(azimuth), std::cos(polar)};
    }
    return found;
}

}  // namespace endmill
