// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace endmill {

/// The share of a triangle in which a linear function with these values at the corners is
/// below 0.
inline double share_below(std::array<double, 3> values)
{
    std::ranges::sort(values);
    const auto [a, b, c] = values;
    if (c <= 0)
        return 1;
    if (a >= 0)
        return 0;
    if (b <= 0)
        return 1 - c * c / ((c - a) * (c - b));
    return a * a / ((a - b) * (a - c));
}

/// Where a function is 0 between two ends at which it has different signs: by the
/// parabola through both and the place where a straight line is 0. Near an end, where rounding
/// would bend the parabola, it is that place.
/// \param from, to values at the ends.
/// \param value_at the function of the share of the way, 0 to 1.
template <typename Function>
double crossing_share(double from, double to, const Function& value_at)
{
    constexpr double least_share = 1e-4;
    const double t = from / (from - to);
    if (!(least_share < t && t < 1 - least_share))
        return std::clamp(t, 0.0, 1.0);
    const double value = value_at(t);
    // from + b s + a s^2 has one root between 0 and 1, because its ends differ in sign
    const double a = (value - std::lerp(from, to, t)) / (t * (t - 1));
    const double b = to - from - a;
    const double root = std::sqrt(std::max(0.0, b * b - 4 * a * from));
    const double larger = -(b + std::copysign(root, b)) / 2;
    const double first = larger != 0 ? from / larger : t;
    const double second = a != 0 ? larger / a : t;
    return 0 <= first && first <= 1 ? first : 0 <= second && second <= 1 ? second : t;
}

}  // namespace endmill
