// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/interval_series.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr Interval one(double number)
{
    return {number, number};
}

// 2 + u - v + u^2 + 3 u v about (0, 0).
IntervalSeries<3> polynomial()
{
    IntervalSeries<3> series;
    series(0, 0) = one(2);
    series(1, 0) = one(1);
    series(0, 1) = one(-1);
    series(2, 0) = one(1);
    series(1, 1) = one(3);
    return series;
}

TEST(IntervalSeries, HasTheDerivativesOfThePolynomial)
{
    const IntervalSeries<2> by_u = polynomial().derivative_u();
    EXPECT_EQ(by_u(0, 0).low, 1);
    EXPECT_EQ(by_u(1, 0).low, 2);
    EXPECT_EQ(by_u(0, 1).low, 3);
    const IntervalSeries<2> by_v = polynomial().derivative_v();
    EXPECT_EQ(by_v(0, 0).high, -1);
    EXPECT_EQ(by_v(1, 0).high, 3);
    EXPECT_EQ(polynomial().up_to<1>()(0, 1).low, -1);
}

// The square of the root, and the product with the quotient, are the polynomial.
TEST(IntervalSeries, RootAndQuotientUndoProducts)
{
    const IntervalSeries<3> a = polynomial();
    const IntervalSeries<3> root = square_root(a);
    const IntervalSeries<3> again = root * root;
    const IntervalSeries<3> quotient = (a * root) / root;
    for (int n = 0; n <= 3; ++n)
        for (int j = 0; j <= n; ++j) {
            EXPECT_NEAR(again(n - j, j).low, a(n - j, j).low, 1e-14);
            EXPECT_NEAR(quotient(n - j, j).high, a(n - j, j).high, 1e-14);
            EXPECT_NEAR((a + -1.0 * quotient)(n - j, j).low, 0, 1e-14);
        }
}

}  // namespace
}  // namespace endmill
