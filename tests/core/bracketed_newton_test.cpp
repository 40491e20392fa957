// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/bracketed_newton.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr double least_step = 1e-15;

// On a line Newton's step is the root itself.
TEST(RootStep, IsNewtonsInsideTheBracketAndTheMiddleOutside)
{
    const RootStep inside = root_step(0, 1, 0.9, {0.9 - 0.25, 1});
    EXPECT_TRUE(inside.is_newton);
    EXPECT_EQ(inside.next, 0.25);
    for (const double slope : {0.1, -1.0, 0.0}) {
        const RootStep middle = root_step(0, 1, 0.9, {0.65, slope});
        EXPECT_FALSE(middle.is_newton) << slope;
        EXPECT_EQ(middle.next, 0.5) << slope;
    }
    EXPECT_EQ(root_step(0, 1, 0.9, {0, 0}).next, 0.5) << "0 / 0 is not a number";
}

TEST(BracketedNewton, FindsRootsWhetherTheFunctionRisesOrFalls)
{
    const auto square = [](double x) { return ValueAndSlope{x * x - 2, 2 * x}; };
    EXPECT_NEAR(bracketed_newton({1, 2, true, 1.9}, least_step, square),
                std::numbers::sqrt2, 4e-16);
    EXPECT_NEAR(bracketed_newton({-2, -1, false, -1.9}, least_step, square),
                -std::numbers::sqrt2, 4e-16);
}

// Newton's method alone diverges from these starts, or meets a derivative of 0.
TEST(BracketedNewton, HalvesWhereAStepLeavesTheBracket)
{
    const auto flat = [](double x) {
        return ValueAndSlope{std::atan(x - 0.3), 1 / (1 + (x - 0.3) * (x - 0.3))};
    };
    EXPECT_NEAR(bracketed_newton({-100, 90, true, 80}, least_step, flat), 0.3, 1e-15);
    const auto cubic = [](double x) { return ValueAndSlope{x * x * x - 8, 3 * x * x}; };
    EXPECT_NEAR(bracketed_newton({-1, 3, true, 0}, least_step, cubic), 2, 4e-16);
}

TEST(BracketedNewton, EndsAtASignChangeWithoutAZero)
{
    const auto step = [](double x) { return ValueAndSlope{x < 0.7 ? -1.0 : 1.0, 0}; };
    EXPECT_NEAR(bracketed_newton({0, 1, true, 0.5}, least_step, step), 0.7, 1e-14);
}

}  // namespace
}  // namespace endmill
