// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/core/vec.h"
#include "endmill/machine/axis_limits.h"
#include "random.h"

// Directions about +Z, given in degrees.
namespace endmill::test {

inline constexpr double degree = std::numbers::pi / 180;
inline const Vec3 up = Vec3::UnitZ();

/// Azimuth and polar angle of a direction, in degrees.
struct AzimuthPolar {
    double azimuth;
    double polar;
};

inline Vec3 direction(const AzimuthPolar& at)
{
    const double p = at.polar * degree;
    return {std::sin(p) * std::cos(at.azimuth * degree),
            std::sin(p) * std::sin(at.azimuth * degree), std::cos(p)};
}

inline std::vector<Vec3> directions(const std::vector<AzimuthPolar>& points)
{
    std::vector<Vec3> result;
    for (const AzimuthPolar& at : points)
        result.push_back(direction(at));
    return result;
}

/// The direction R_a(alpha) R_b(beta) z: z turned by beta about +Y, then by alpha about
/// +X, degrees.
inline Vec3 turned_to(double alpha, double beta)
{
    const double a = alpha * degree;
    const double b = beta * degree;
    return {std::sin(b), -std::sin(a) * std::cos(b), std::cos(a) * std::cos(b)};
}

/// `count` directions at equal azimuths about +Z.
inline std::vector<Vec3> ring(int count, double polar)
{
    std::vector<Vec3> result;
    for (int i = 0; i < count; ++i)
        result.push_back(direction({360.0 * i / count, polar}));
    return result;
}

/// 3 to 32 random directions within 85 degrees of +Z.
inline std::vector<Vec3> random_directions(Random& random)
{
    std::vector<Vec3> result;
    const int count = 3 + static_cast<int>(random.uniform(0, 30));
    for (int i = 0; i < count; ++i) {
        const double azimuth = random.uniform(0, 360);
        result.push_back(direction({azimuth, 85 * std::sqrt(random.uniform(0, 1))}));
    }
    return result;
}

inline double square_degrees(double area)
{
    return area / (degree * degree);
}

/// A range given in degrees.
inline RotaryRange degrees(double from, double to)
{
    return {from * degree, to * degree};
}

inline void expect_range(const RotaryRange& range, double from_deg, double to_deg)
{
    EXPECT_NEAR(range.from, from_deg * degree, 1e-9);
    EXPECT_NEAR(range.to, to_deg * degree, 1e-9);
}

}  // namespace endmill::test
