// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/planning/detail/least_squares.h"

#include <limits>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

const std::vector<Interval> box{{-3, 3}, {-3, 3}};

// Rosenbrock's valley: 100 (y - x^2)^2 + (1 - x)^2, with its minimum 0 at (1, 1).
std::optional<Eigen::VectorXd> valley(std::span<const double> x)
{
    return Eigen::VectorXd{Eigen::Vector2d{10 * (x[1] - x[0] * x[0]), 1 - x[0]}};
}

TEST(LeastSquares, FollowACurvedValley)
{
    const LeastSquares found = least_squares(box, valley, {-1.2, 1}, 200);
    EXPECT_LT(found.squares, 1e-10);
    EXPECT_NEAR(found.values[0], 1, 1e-5);
    EXPECT_NEAR(found.values[1], 1, 1e-5);
}

// Three equations for two values: the normal equations have the solution (2, 1).
TEST(LeastSquares, SolveTheNormalEquations)
{
    const auto line = [](std::span<const double> x) {
        return std::optional<Eigen::VectorXd>{
            Eigen::Vector3d{x[0] - 1.5, x[0] + x[1] - 3, x[0] + 2 * x[1] - 4.5}};
    };
    // r = c + d t for t = 0, 1, 2 with data 1.5, 3, 4.5: c = 1.5, d = 1.5 exactly.
    const LeastSquares found = least_squares(box, line, {0, 0}, 50);
    EXPECT_NEAR(found.values[0], 1.5, 1e-6);
    EXPECT_NEAR(found.values[1], 1.5, 1e-6);
}

TEST(LeastSquares, StayInTheBox)
{
    const std::vector<Interval> narrow{{-3, 0.5}, {-3, 3}};
    const LeastSquares found = least_squares(narrow, valley, {-1.2, 1}, 200);
    EXPECT_LE(found.values[0], 0.5);
    // On the border x = 0.5 the minimum lies at y = 0.25, where the squares are 0.25.
    EXPECT_NEAR(found.squares, 0.25, 0.05);
}

TEST(LeastSquares, NeverGetWorseAndEndWhereThereAreNoResiduals)
{
    const auto steps = [](std::span<const double> x) {
        return std::optional<Eigen::VectorXd>{
            Eigen::Vector2d{std::floor(x[0]), std::floor(x[1])}};
    };
    EXPECT_LE(least_squares(box, steps, {1.5, 1.5}, 20).squares, 2);
    const auto nowhere = [](std::span<const double>) {
        return std::optional<Eigen::VectorXd>{};
    };
    const LeastSquares none = least_squares(box, nowhere, {1, 1}, 20);
    EXPECT_EQ(none.squares, std::numeric_limits<double>::infinity());
    EXPECT_EQ(none.values, (std::vector<double>{1, 1}));
}

}  // namespace
}  // namespace endmill
