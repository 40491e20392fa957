// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/spherical_turn.h"

#include <gtest/gtest.h>

#include "direction_sets.h"

namespace endmill {
namespace {

using test::Random;

// Coordinates are multiples of 2^-18 below 1. Determinants then have at most 61 bits and
// are exact in a long double.
Vec3 coarse_vector(Random& random)
{
    const auto coordinate = [&random] {
        return std::floor(random.uniform(-1, 1) * 0x1p+18) * 0x1p-18;
    };
    const double x = coordinate();
    const double y = coordinate();
    return {x, y, coordinate()};
}

int sign(long double value)
{
    return (value > 0) - (value < 0);
}

long double determinant(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const auto minor = [&](int i, int j) {
        return static_cast<long double>(a[i]) * b[j] -
               static_cast<long double>(a[j]) * b[i];
    };
    return p[0] * minor(1, 2) + p[1] * minor(2, 0) + p[2] * minor(0, 1);
}

TEST(SphericalTurn, IsTheSignOfTheDeterminantWhereThatIsExact)
{
    Random random{1};
    for (int i = 0; i < 2000; ++i) {
        const Vec3 p = coarse_vector(random);
        const Vec3 a = coarse_vector(random);
        const Vec3 b = coarse_vector(random);
        // Nearly or exactly in the plane of the other two vectors.
        Vec3 c = i % 5 == 0 ? b : Vec3{a + b};
        c[i % 3] += 0x1p-18 * (i % 2);
        EXPECT_EQ(turn_about(p, a, c), sign(determinant(p, a, c)));
        EXPECT_EQ(turn_along(p, a, b, c), sign(determinant(p, b - a, c - a)));
        EXPECT_EQ(order_along(p, a, b, c), sign(determinant(p, a, c - b)));
        EXPECT_EQ(turn_about(p, a, c), exact_turn_about(p, a, c));
        EXPECT_EQ(turn_along(p, a, b, c), exact_turn_along(p, a, b, c));
        EXPECT_EQ(order_along(p, a, b, c), exact_order_along(p, a, b, c));
        EXPECT_EQ(side_of(p, c), exact_side_of(p, c));
    }
}

// 0.1 + 0.2 - 0.3 is not 0 in doubles, so that the exact sign is not 0 either. A vector
// multiplied by a power of two is exactly collinear.
TEST(SphericalTurn, DependsOnTheLastBit)
{
    const Vec3 axis = Vec3::UnitZ();
    const Vec3 a{0.1, 0.7, 0.3};
    EXPECT_EQ(turn_about(axis, a, 2 * a), 0);
    const Vec3 left{a.x(), std::nextafter(a.y(), 1.0), a.z()};
    const Vec3 right{a.x(), std::nextafter(a.y(), 0.0), a.z()};
    EXPECT_EQ(turn_about(axis, a, left), 1);
    EXPECT_EQ(turn_about(axis, a, right), -1);
    EXPECT_EQ(turn_along(axis, Vec3::Zero(), a, left), 1);
    EXPECT_EQ(order_along(axis, Vec3::UnitX(), a, left), 1);
    EXPECT_EQ(order_along(axis, Vec3::UnitX(), a, right), -1);
}

TEST(SphericalTurn, DecidesTheSideOfAGreatCircleExactly)
{
    const Vec3 axis{0.6, 0.8, 0.1};
    const Vec3 across{0.8, -0.6, 0.0};
    EXPECT_EQ(side_of(axis, {-axis.y(), axis.x(), 0}), 0);
    EXPECT_EQ(side_of(axis, {-axis.y(), axis.x(), 1e-300}), 1);
    EXPECT_EQ(side_of(axis, {-axis.y(), axis.x(), -1e-300}), -1);
    // Both products 0.6 * 0.8 have the same factors, so that they are equal exactly too.
    EXPECT_EQ(side_of(axis, across), 0);
}

}  // namespace
}  // namespace endmill
