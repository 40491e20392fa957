// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "endmill/offset/section_curve.h"

namespace endmill {

/// Random numbers as datasets/offset-curves/random-families.json defines them.
class ChainNoise {
public:
    /// Normally distributed, variance 1.
    double normal()
    {
        const double first = uniform();
        const double second = uniform();
        return std::sqrt(-2 * std::log(1 - first)) *
               std::cos(2 * std::numbers::pi * second);
    }

private:
    double uniform()
    {
        const double low = engine_();
        const double high = engine_();
        const double share = (low + 4294967296.0 * high) / 18446744073709551616.0;
        return share < 1 ? share : 1 - 0x1p-53;
    }

    std::mt19937 engine_{7};
};

/// The raw offset, upwards by 3 mm, of a profile of two sines sampled every 0.05 mm, for
/// `segments` segments. Each segment of the profile is moved along its normal. Between
/// two of them the chain has an arc, sampled to 1e-4, where the profile is convex, and a
/// straight line back where it is concave.
/// \param noise standard deviation of the noise on the profile, in mm.
inline SectionCurve raw_chain(std::size_t segments, double noise)
{
    constexpr double radius = 3;
    const double largest_step = 2 * std::acos(1 - 1e-4 / radius);
    ChainNoise random;
    std::size_t vertices = 0;
    const auto next_vertex = [&] {
        const double x = 0.05 * static_cast<double>(vertices++);
        const double z = std::sin(2 * std::numbers::pi * x / 5) +
                         4 * std::sin(2 * std::numbers::pi * x / 37);
        return SectionPoint{x, noise > 0 ? z + noise * random.normal() : z};
    };
    const auto moved = [&](const SectionPoint& point, double angle) {
        return SectionPoint{point[0] - radius * std::sin(angle),
                            point[1] + radius * std::cos(angle)};
    };
    SectionCurve curve;
    SectionPoint from = next_vertex();
    double last_angle =
        -std::numbers::pi;  // below every angle: no arc before the first segment
    while (curve.points.size() <= segments) {
        const SectionPoint to = next_vertex();
        const double angle = std::atan2(to[1] - from[1], to[0] - from[0]);
        const int steps =
            static_cast<int>(std::ceil((last_angle - angle) / largest_step));
        for (int k = 1; k < steps; ++k)
            curve.points.push_back(
                moved(from, last_angle + (angle - last_angle) * k / steps));
        curve.points.push_back(moved(from, angle));
        curve.points.push_back(moved(to, angle));
        from = to;
        last_angle = angle;
    }
    curve.points.resize(segments + 1);
    return curve;
}

/// The same turned by 90 degrees.
inline SectionCurve turned(SectionCurve curve)
{
    for (SectionPoint& point : curve.points)
        point = {-point[1], point[0]};
    return curve;
}

}  // namespace endmill
