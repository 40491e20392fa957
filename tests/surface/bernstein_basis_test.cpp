// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/bernstein_basis.h"

#include <cmath>

#include <gtest/gtest.h>

#include "endmill/surface/detail/cubic_bernstein.h"

namespace endmill {
namespace {

// By the binomial formula; zero where i is not from 0 to degree.
double bernstein(int degree, int i, double t)
{
    if (i < 0 || i > degree)
        return 0;
    double binomial = 1;
    for (int k = 1; k <= i; ++k)
        binomial *= double(degree - k + 1) / k;
    return binomial * std::pow(t, i) * std::pow(1 - t, degree - i);
}

TEST(BernsteinBasis, IsTheBinomialFormulaAndItsDerivatives)
{
    for (const int n : {1, 2, 3, 4, 7, 25})
        for (double t = 0; t <= 1; t += 0.125) {
            const auto basis = bernstein_basis<3>(n, t);
            ASSERT_EQ(basis.rows(), n + 1);
            for (int i = 0; i <= n; ++i) {
                const auto lower = [&](int degree, int shift) {
                    return bernstein(degree, i - shift, t);
                };
                EXPECT_NEAR(basis(i, 0), bernstein(n, i, t), 1e-14);
                EXPECT_NEAR(basis(i, 1), n * (lower(n - 1, 1) - lower(n - 1, 0)), 1e-12);
                EXPECT_NEAR(basis(i, 2),
                            n * (n - 1) *
                                (lower(n - 2, 2) - 2 * lower(n - 2, 1) + lower(n - 2, 0)),
                            1e-11);
            }
        }
}

TEST(BernsteinBasis, OfAConstantIsOne)
{
    const auto basis = bernstein_basis<3>(0, 0.3);
    ASSERT_EQ(basis.rows(), 1);
    EXPECT_EQ(basis(0, 0), 1);
    EXPECT_EQ(basis(0, 1), 0);
    EXPECT_EQ(basis(0, 2), 0);
}

TEST(BernsteinBasis, OfDegreeThreeIsTheCubicOne)
{
    for (double t = -0.5; t <= 1.5; t += 0.1)
        EXPECT_LT((bernstein_basis<3>(3, t) - cubic_bernstein<3>(t)).norm(), 1e-13);
}

TEST(BernsteinBasis, SumsToOne)
{
    for (int n = 1; n <= most_degree; ++n)
        for (double t = 0; t <= 1; t += 0.0625)
            EXPECT_NEAR(bernstein_basis<1>(n, t).sum(), 1, 1e-14);
}

}  // namespace
}  // namespace endmill
