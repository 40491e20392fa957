// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/parameter.h"

#include <cmath>

#include "endmill/core/numbers.h"

namespace endmill {

namespace {

// `value` to `decimals`; never -0.
std::string rounded_text(double value, int decimals)
{
    const double scale = std::pow(10, decimals);
    const double rounded = std::round(value * scale) / scale;
    return to_text(rounded + 0.0);
}

}  // namespace

std::string place_text(const SurfacePoint& at, const Vec3& point)
{
    constexpr int decimals_of_parameters = 4;
    constexpr int decimals_of_mm = 3;
    const auto parameter = [](double value) {
        return rounded_text(value, decimals_of_parameters);
    };
    const auto mm = [](double value) { return rounded_text(value, decimals_of_mm); };
    return "u = " + parameter(at.u) + ", v = " + parameter(at.v) + " (" + mm(point.x()) +
           ", " + mm(point.y()) + ", " + mm(point.z()) + " mm)";
}

}  // namespace endmill
