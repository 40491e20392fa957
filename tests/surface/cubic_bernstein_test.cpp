// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/surface/detail/cubic_bernstein.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// The matrix from powers to Bernstein polynomials. [KimChoi, section 2], whose print has
// 1 instead of 0 at the end of the third row.
Eigen::Matrix4d power_matrix(double end_of_third_row)
{
    Eigen::Matrix4d m;
    m << 1, 0, 0, 0, -3, 3, 0, 0, 3, -6, 3, end_of_third_row, -1, 3, -3, 1;
    return m;
}

Eigen::Matrix<double, 3, 4> powers_and_derivatives(double t)
{
    Eigen::Matrix<double, 3, 4> powers;
    powers << 1, t, t * t, t * t * t, 0, 1, 2 * t, 3 * t * t, 0, 0, 2, 6 * t;
    return powers;
}

TEST(CubicBernstein, IsThePowerBasisTimesTheMatrixOfThePaper)
{
    for (double t = -0.5; t <= 1.5; t += 0.0625) {
        const Eigen::Matrix<double, 3, 4> expected =
            powers_and_derivatives(t) * power_matrix(0);
        EXPECT_LT((cubic_bernstein<3>(t).transpose() - expected).norm(), 1e-13) << t;
    }
}

TEST(CubicBernstein, SumsToOneAndItsDerivativesToZero)
{
    for (double t = 0; t <= 1; t += 0.01) {
        const Eigen::RowVector3d sums = cubic_bernstein<3>(t).colwise().sum();
        EXPECT_NEAR(sums[0], 1, 1e-15) << t;
        EXPECT_NEAR(sums[1], 0, 1e-14) << t;
        EXPECT_NEAR(sums[2], 0, 1e-14) << t;
    }
}

TEST(CubicBernstein, ThePrintedMatrixDoesNotSumToOne)
{
    const double t = 0.5;
    const Eigen::Matrix<double, 3, 4> printed =
        powers_and_derivatives(t) * power_matrix(1);
    EXPECT_NEAR(printed.row(0).sum(), 1 + t * t, 1e-15);
}

TEST(CubicBernstein, WithTwoColumnsIsTheStartOfTheOneWithThree)
{
    for (const double t : {-1.0, 0.0, 0.3, 1.0, 2.0})
        EXPECT_EQ(cubic_bernstein<2>(t), cubic_bernstein<3>(t).leftCols<2>()) << t;
}

TEST(CubicBernstein, AtTheEndsHasOnlyTheEndPointAndExactSlopes)
{
    Eigen::Matrix<double, 4, 3> at_0;
    at_0 << 1, -3, 6, 0, 3, -12, 0, 0, 6, 0, 0, 0;
    EXPECT_EQ(cubic_bernstein<3>(0), at_0);
    Eigen::Matrix<double, 4, 3> at_1;
    at_1 << 0, 0, 0, 0, 0, 6, 0, -3, -12, 1, 3, 6;
    EXPECT_EQ(cubic_bernstein<3>(1), at_1);
}

}  // namespace
}  // namespace endmill
