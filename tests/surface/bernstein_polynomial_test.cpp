// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_polynomial.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/surface/detail/bernstein_basis.h"
#include "random.h"

namespace endmill {
namespace {

// By the basis polynomials instead of de Casteljau's algorithm.
double value(const BernsteinPolynomial& polynomial, double t)
{
    const int degree = static_cast<int>(polynomial.size()) - 1;
    const auto basis = bernstein_basis<1>(degree, t);
    double sum = 0;
    for (int i = 0; i <= degree; ++i)
        sum += basis(i, 0) * polynomial[i];
    return sum;
}

// The polynomial times (t - root), by the product rule of Bernstein coefficients.
BernsteinPolynomial times_root(const BernsteinPolynomial& polynomial, double root)
{
    const std::size_t degree = polynomial.size();
    BernsteinPolynomial product(degree + 1, 0.0);
    for (std::size_t i = 0; i <= degree; ++i) {
        const double share = double(i) / double(degree);
        if (i > 0)
            product[i] += share * (1 - root) * polynomial[i - 1];
        if (i < degree)
            product[i] += (1 - share) * -root * polynomial[i];
    }
    return product;
}

TEST(BernsteinPolynomial, RestrictedIsTheSameOnItsInterval)
{
    test::Random random{1};
    for (int trial = 0; trial < 50; ++trial) {
        BernsteinPolynomial whole(2 + trial % 20);
        for (double& coefficient : whole)
            coefficient = random.uniform(-1, 1);
        const double from = random.uniform(0, 0.5);
        const double to = random.uniform(0.6, 1);
        const BernsteinPolynomial part = restricted(whole, from, to);
        for (double t = 0; t <= 1; t += 0.25)
            EXPECT_NEAR(value(part, t), value(whole, from + t * (to - from)), 1e-14);
    }
}

TEST(FirstRiseToZero, IsTheLeastOfTheRootsGiven)
{
    test::Random random{2};
    for (int trial = 0; trial < 300; ++trial) {
        BernsteinPolynomial polynomial{1};
        double least = 2;
        // An odd number, so that it starts below zero.
        const int roots = 1 + 2 * (trial % 4);
        for (int k = 0; k < roots; ++k) {
            const double root = random.uniform(0.05, 1.3);
            least = std::min(least, root);
            polynomial = times_root(polynomial, root);
        }
        ASSERT_LT(polynomial.front(), 0);
        const auto found = first_rise_to_zero(polynomial);
        ASSERT_EQ(found.has_value(), least <= 1) << trial;
        if (!found)
            continue;
        EXPECT_NEAR(value(polynomial, *found), 0, 1e-15) << trial;
        EXPECT_LT(*found, least + 1e-3) << "close roots blur each other";
    }
}

TEST(FirstRiseToZero, IsFoundWhereThePolynomialBarelyRises)
{
    // -(t - 1/2)^2 (t - 3) (t - 4) + 1e-13: above zero on a width of 2e-7
    BernsteinPolynomial touching = times_root(times_root({-1}, 0.5), 0.5);
    touching = times_root(times_root(touching, 3), 4);
    for (double& coefficient : touching)
        coefficient += 1e-13;
    const auto found = first_rise_to_zero(touching);
    ASSERT_TRUE(found);
    EXPECT_NEAR(*found, 0.5, 2e-7);
}

TEST(FirstRiseToZero, IsNotTheZeroAtTheEndIfThereIsOneBefore)
{
    // (t - 1/4) (1 - t) and (5 t - 1) (1 - t)
    EXPECT_EQ(first_rise_to_zero({-0.25, 0.375, 0}).value(), 0.25);
    EXPECT_NEAR(first_rise_to_zero({-1, 2, 0}).value(), 0.2, 1e-15);
    EXPECT_EQ(first_rise_to_zero({-1, -1, 0}).value(), 1);
}

TEST(FirstRiseToZero, IsNothingBelowZeroThroughout)
{
    EXPECT_FALSE(first_rise_to_zero({-1, 3, -9, 3, -1, -2}));
    EXPECT_FALSE(first_rise_to_zero({-1, -2}));
    EXPECT_EQ(first_rise_to_zero({-1, 1}), 0.5);
}

}  // namespace
}  // namespace endmill
