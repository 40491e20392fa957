// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/cubic_root.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

using Bernstein = std::array<double, 4>;

// In long double and by powers instead of de Casteljau's algorithm.
long double value(const Bernstein& b, long double t)
{
    const long double s = 1 - t;
    return b[0] * s * s * s + 3 * b[1] * s * s * t + 3 * b[2] * s * t * t +
           b[3] * t * t * t;
}

double size(const Bernstein& b)
{
    return std::max({std::abs(b[0]), std::abs(b[1]), std::abs(b[2]), std::abs(b[3])});
}

// Bernstein coefficients of (t - p) (t - q) (t - r) + lift, each rounded once.
Bernstein with_roots(long double p, long double q, long double r, long double lift = 0)
{
    const std::array<long double, 3> powers{p * q + p * r + q * r, -(p + q + r), 1};
    const long double start = -p * q * r;
    const long double after_one = start + powers[0] / 3;
    return {double(start + lift), double(after_one + lift),
            double(start + (2 * powers[0] + powers[1]) / 3 + lift),
            double(start + powers[0] + powers[1] + powers[2] + lift)};
}

// Whether the cubic reaches `level` somewhere on a fine grid of [0, until].
bool reaches(const Bernstein& b, double until, long double level)
{
    constexpr int steps = 2000;
    for (int k = 0; k <= steps; ++k)
        if (value(b, until * k / static_cast<long double>(steps)) >= level)
            return true;
    return false;
}

TEST(CubicRoot, OfAStraightLineIsItsRoot)
{
    EXPECT_NEAR(first_rise_to_zero({-1, 0, 1, 2}).value(), 1.0 / 3, 1e-16);
    EXPECT_EQ(first_rise_to_zero({-3, -2, -1, 0}).value(), 1);
    EXPECT_FALSE(first_rise_to_zero({-4, -3, -2, -1}));
}

TEST(CubicRoot, OfRandomCubicsIsTheFirstThatADenseScanFinds)
{
    test::Random random{1};
    double worst = 0;
    int found = 0;
    for (int k = 0; k < 3000; ++k) {
        const double scale = random.log_uniform(1e-6, 1e6);
        Bernstein b;
        for (double& coefficient : b)
            coefficient = scale * random.uniform(-1, 1);
        b[0] = -std::abs(b[0]) - 1e-3 * scale;
        const auto root = first_rise_to_zero(b);
        const long double value_rounding = 1e-14L * size(b);
        EXPECT_FALSE(reaches(b, root ? *root * (1 - 1e-9) : 1, value_rounding)) << k;
        if (!root)
            continue;
        ++found;
        EXPECT_TRUE(0 <= *root && *root <= 1);
        worst = std::max(worst, std::abs(double(value(b, *root))) / size(b));
    }
    EXPECT_GT(found, 1000);
    EXPECT_LT(worst, 1e-15) << "a few roundings of the largest coefficient";
}

TEST(CubicRoot, IsTheFirstOfTwoCloseRoots)
{
    test::Random random{2};
    for (const double apart : {1e-1, 1e-3, 1e-5, 1e-6})
        for (int k = 0; k < 300; ++k) {
            const double p = random.uniform(0.05, 0.8);
            const double third = random.uniform(1.5, 3);
            const Bernstein b = with_roots(p, p + apart, third);
            ASSERT_LT(b[0], 0);
            const auto root = first_rise_to_zero(b);
            ASSERT_TRUE(root) << p << ' ' << apart;
            // Rounding the coefficients moves a root by rounding / slope.
            EXPECT_NEAR(*root, p, 1e-15 / apart + 1e-15);
        }
}

TEST(CubicRoot, FindsATouchOfARootThatIsExactInBinary)
{
    // (t - 1/2)^2 (t - 2) touches zero from below at 1/2.
    const auto root = first_rise_to_zero(with_roots(0.5, 0.5, 2));
    ASSERT_TRUE(root);
    EXPECT_NEAR(*root, 0.5, 1e-7);
}

TEST(CubicRoot, FindsATouchThatOneRoundingLiftsToZero)
{
    test::Random random{3};
    for (int k = 0; k < 1000; ++k) {
        const double p = random.uniform(0.05, 0.95);
        const double third = random.uniform(1.2, 4);
        const double lift = 2.3e-16 * size(with_roots(p, p, third));
        const auto root = first_rise_to_zero(with_roots(p, p, third, lift));
        ASSERT_TRUE(root) << p;
        EXPECT_NEAR(*root, p, 2e-7);
    }
}

TEST(CubicRoot, SkipsAMaximumBelowZero)
{
    const auto root = first_rise_to_zero(with_roots(0.3, 0.3, 0.9, -1e-12));
    ASSERT_TRUE(root);
    EXPECT_NEAR(*root, 0.9, 1e-10);
}

TEST(CubicRoot, FindsATripleRootAndAFlatInflection)
{
    for (const double p : {0.1, 0.25, 0.5, 0.7, 1.0}) {
        const auto root = first_rise_to_zero(with_roots(p, p, p));
        ASSERT_TRUE(root) << p;
        EXPECT_NEAR(*root, p, 1e-5) << "the cube root of rounding";
    }
}

TEST(CubicRoot, OfAQuadraticIsItsFirst)
{
    // -(t - 1/4)(t - 3/4): the third difference is zero.
    const double c = 3.0 / 16;
    const Bernstein b{-c, -c + 1.0 / 3, -c + 1.0 / 3, -c};
    EXPECT_NEAR(first_rise_to_zero(b).value(), 0.25, 1e-15);
}

TEST(CubicRoot, DoesNotExistIfTheCubicStaysBelowZero)
{
    EXPECT_FALSE(first_rise_to_zero({-1, -1, -1, -1}));
    EXPECT_FALSE(first_rise_to_zero({-1, -1e-300, -1, -5}));
    EXPECT_FALSE(
        // The convex hull reaches zero, the cubic does not.
        first_rise_to_zero({-1, 1, -1, -1}));
}

TEST(CubicRoot, KeepsItsAccuracyWhereCoefficientsDifferByManyOrders)
{
    test::Random random{4};
    for (int k = 0; k < 2000; ++k) {
        Bernstein b;
        for (double& coefficient : b)
            coefficient =
                random.log_uniform(1e-12, 1e3) * (random.uniform(-1, 1) < 0 ? -1 : 1);
        b[0] = -std::abs(b[0]);
        const auto root = first_rise_to_zero(b);
        if (root) {
            EXPECT_LT(std::abs(double(value(b, *root))), 2e-15 * size(b)) << k;
        }
    }
}

TEST(RestrictToUpperEnd, IsTheSameCubicOnTheRestOfItsInterval)
{
    const Bernstein b{-2, 1, 0.5, 3};
    for (const double from : {0.0, 0.1, 0.5, 0.99, 1.0}) {
        const Bernstein rest = restrict_to_upper_end(b, from);
        for (const double t : {0.0, 0.3, 0.6, 1.0})
            EXPECT_NEAR(double(value(rest, t)), double(value(b, from + t * (1 - from))),
                        1e-14);
    }
    EXPECT_EQ(restrict_to_upper_end(b, 0), b);
}

}  // namespace
}  // namespace endmill
