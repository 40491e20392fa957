// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/orientation.h"

#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

__extension__ using Int128 = __int128;
using Whole = std::array<std::int64_t, 3>;

Vec3 point(const Whole& whole)
{
    return {double(whole[0]), double(whole[1]), double(whole[2])};
}

// The cross product in integers: coordinates below 2^52 have products of at most 106
// bits.
bool collinear_in_whole_numbers(const Whole& a, const Whole& b, const Whole& c)
{
    const auto minor = [&](int i, int j) {
        return Int128{b[i] - a[i]} * (c[j] - a[j]) - Int128{b[j] - a[j]} * (c[i] - a[i]);
    };
    return minor(0, 1) == 0 && minor(1, 2) == 0 && minor(2, 0) == 0;
}

Whole random_whole(test::Random& random, double size)
{
    Whole whole;
    for (std::int64_t& coordinate : whole)
        coordinate = std::llround(random.uniform(-size, size));
    return whole;
}

Whole at(const Whole& start, const Whole& step, std::int64_t steps)
{
    return {start[0] + steps * step[0], start[1] + steps * step[1],
            start[2] + steps * step[2]};
}

TEST(AreCollinear, AgreesWithIntegerArithmetic)
{
    test::Random random{1};
    int apart = 0;
    for (int trial = 0; trial < 20000; ++trial) {
        const Whole a = random_whole(random, std::ldexp(1, 50));
        const Whole step = random_whole(random, std::ldexp(1, 24));
        const Whole b = at(a, step, std::llround(random.uniform(-1e6, 1e6)));
        Whole c = at(a, step, std::llround(random.uniform(-1e6, 1e6)));
        EXPECT_TRUE(are_collinear(point(a), point(b), point(c)));
        c[trial % 3] += trial % 2 ? 1 : -1;
        const bool expected = collinear_in_whole_numbers(a, b, c);
        EXPECT_EQ(are_collinear(point(a), point(b), point(c)), expected);
        apart += !expected;
    }
    EXPECT_GT(apart, 19000);
}

TEST(AreCollinear, HoldsForEqualPointsAndOnAnAxis)
{
    const Vec3 a{0.1, 0.2, 0.3};
    const Vec3 b{1e-7, 1e6, -3};
    EXPECT_TRUE(are_collinear(a, a, a));
    EXPECT_TRUE(are_collinear(a, a, b));
    EXPECT_TRUE(are_collinear(a, b, a));
    EXPECT_TRUE(are_collinear(b, a, a));
    EXPECT_TRUE(are_collinear({0.1, 7, 1.1}, {0.1, 7, -3.3}, {0.1, 7, 1e-9}));
}

TEST(AreCollinear, DependsOnTheLastBitOfACoordinate)
{
    // 3 a and 5 a are exact because a has few bits; one of 0.1, 0.3 and 0.5 is rounded.
    const Vec3 a{0.1F, 0.7F, 0.3F};
    EXPECT_TRUE(are_collinear(a, 3 * a, 5 * a));
    Vec3 b = 5 * a;
    b.z() = std::nextafter(b.z(), 9);
    EXPECT_FALSE(are_collinear(a, 3 * a, b));
    EXPECT_FALSE(are_collinear({0.1, 0.1, 0}, {0.3, 0.3, 0}, {0.5, 0.5, 1e-140}));
}

TEST(AreCollinear, DoesNotDependOnTheSizeOrOrderOfThePoints)
{
    const Vec3 a{1, 2, 4};
    const Vec3 b{3, 7, 1};
    const Vec3 c = a + 4 * (b - a);
    const Vec3 d{13, 22, -11 + 1e-15};
    for (const double scale : {1e-139, 1e-70, 1.0, 1e70, 1e138}) {
        const double power = std::exp2(std::round(std::log2(scale)));
        for (const auto& [p, q, r] : {std::array{a, b, c}, {b, c, a}, {c, b, a}})
            EXPECT_TRUE(are_collinear(power * p, power * q, power * r));
        EXPECT_TRUE(are_collinear(power * a, power * b, power * Vec3{9, 22, -8}));
        EXPECT_FALSE(are_collinear(power * a, power * b, power * d));
    }
}

}  // namespace
}  // namespace endmill
