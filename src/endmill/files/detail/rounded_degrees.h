// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "endmill/core/angle.h"

namespace endmill {

/// An angle in degrees, rounded to 1e-9 degrees. Results are less accurate than that; the
/// rounding makes 5 degrees read "5" instead of "5.000000000000001".
/// \param radians the angle in rad.
inline double rounded_degrees(double radians)
{
    constexpr double steps_per_degree = 1e9;
    return std::round(Angle::radians(radians).degrees() * steps_per_degree) /
           steps_per_degree;
}

}  // namespace endmill
