// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/cutting_coefficients.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "random.h"
#include "sliced_coefficients.h"

namespace endmill {
namespace {

using std::numbers::pi;
using test::listed;

constexpr double largest_angle = 80 * pi / 180;

struct Errors {
    double root_mean_square = 0;  // error of the worst coefficient
    double largest = 0;
};

Errors errors(const CoefficientTable& table, int samples)
{
    test::Random random{41};
    std::array<double, 8> squares{};
    Errors found;
    for (int n = 0; n < samples; ++n) {
        const BallEngagement e{random.uniform(-largest_angle, largest_angle),
                               random.uniform(-largest_angle, largest_angle),
                               random.uniform(0, 1), random.uniform(0, 1.5)};
        const auto in_table = listed(table.coefficients(e));
        const auto exact = listed(cutting_coefficients(e, ChipModel::Paper, 1e-6));
        for (std::size_t k = 0; k < squares.size(); ++k) {
            const double error = std::abs(in_table[k] - exact[k]);
            squares[k] += error * error / samples;
            found.largest = std::max(found.largest, error);
        }
    }
    found.root_mean_square = std::sqrt(*std::max_element(squares.begin(), squares.end()));
    return found;
}

TEST(CoefficientTable, HasTheStatedAccuracy)
{
    const CoefficientTable table;
    const Errors found = errors(table, 20000);
    EXPECT_LT(found.root_mean_square, 3e-3);
    EXPECT_LT(found.largest, 2.5e-2);
    EXPECT_GT(found.largest, 5e-3);  // the interpolation error is visible
}

TEST(CoefficientTable, OfHalfTheStepsHasLessThanHalfTheError)
{
    const Errors coarse = errors(CoefficientTable{ChipModel::Paper, {9, 5, 5}}, 5000);
    const Errors fine = errors(CoefficientTable{ChipModel::Paper, {17, 9, 9}}, 5000);
    EXPECT_LT(fine.root_mean_square, 0.45 * coarse.root_mean_square);
}

TEST(CoefficientTable, IsExactAtItsNodes)
{
    const CoefficientTable table{ChipModel::Exact, {5, 3, 3}};
    for (const double mu : {-largest_angle, 0.0, largest_angle / 2})
        for (const double lambda : {-largest_angle / 2, 0.0, largest_angle})
            for (const double ratio : {0.25, 1.0}) {
                const BallEngagement e{mu, lambda, ratio, ratio};
                EXPECT_LT(test::largest_difference(
                              listed(table.coefficients(e)),
                              listed(cutting_coefficients(e, ChipModel::Exact))),
                          1e-6);
            }
}

TEST(CoefficientTable, AddsTheShank)
{
    const CoefficientTable table{ChipModel::Paper, {5, 3, 3}};
    const auto ball = table.coefficients({0.1, 0.2, 0.4, 1});
    const auto deep = table.coefficients({0.1, 0.2, 0.4, 3});
    EXPECT_LT(
        test::largest_difference(
            listed(deep), listed(sum(ball, shank_coefficients({0.1, 0.2, 0.4, 3})))),
        1e-14);
}

TEST(CoefficientTable, ComputesEngagementsOutsideTheTable)
{
    const CoefficientTable table{ChipModel::Paper, {2, 2, 2}};
    for (const BallEngagement& e :
         {BallEngagement{1.5, 0, 0.5, 1}, BallEngagement{0, -1.5, 0.5, 1},
          BallEngagement{0, 0, 1.2, 1},
          BallEngagement{0, 0.4, 0, 1, PreviousPass::None}}) {
        EXPECT_FALSE(table.covers(e));
        EXPECT_LT(test::largest_difference(listed(table.coefficients(e)),
                                           listed(cutting_coefficients(e))),
                  1e-6);
    }
    EXPECT_EQ(listed(table.coefficients({0, 0, 0.5, -1})), (std::array<double, 8>{}));
}

TEST(CoefficientTable, RefusesOptionsOutOfTheirRanges)
{
    EXPECT_THROW((CoefficientTable{ChipModel::Paper, {1, 8, 8}}), DomainError);
    EXPECT_THROW((CoefficientTable{ChipModel::Paper, {17, 65, 8}}), DomainError);
    const CoefficientTable table{ChipModel::Paper, {2, 2, 2}};
    EXPECT_THROW(table.coefficients({2, 0, 0.5, 1}), DomainError);
}

}  // namespace
}  // namespace endmill
