// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/boundary_in_triangle.h"

#include <cmath>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// By the share of points at which a linear function is below 0.
double counted_share(const std::array<double, 3>& values)
{
    constexpr int steps = 400;
    int all = 0;
    int below = 0;
    for (int i = 0; i < steps; ++i)
        for (int j = 0; i + j < steps; ++j) {
            const double a = (i + 1.0 / 3) / steps;
            const double b = (j + 1.0 / 3) / steps;
            ++all;
            below +=
                values[0] + a * (values[1] - values[0]) + b * (values[2] - values[0]) < 0;
        }
    return static_cast<double>(below) / all;
}

TEST(ShareBelow, IsThatOfCountedPoints)
{
    test::Random random{1};
    for (int k = 0; k < 50; ++k) {
        const double a = random.uniform(-1, 1);
        const double b = random.uniform(-1, 1);
        const std::array<double, 3> values{a, b, random.uniform(-1, 1)};
        EXPECT_NEAR(share_below(values), counted_share(values), 0.006);
    }
    EXPECT_EQ(share_below({-1, -2, -3}), 1);
    EXPECT_EQ(share_below({1, 2, 0}), 0);
}

// The distance from a circle along a line: the crossing is known.
TEST(CrossingShare, FindsWhereALineMeetsACircle)
{
    test::Random random{2};
    for (int k = 0; k < 500; ++k) {
        const double beside = random.uniform(0, 0.999);
        const double half = std::sqrt(1 - beside * beside);
        const double from = half - random.uniform(0, 0.2);
        const double to = half + random.uniform(0, 0.2);
        const auto distance = [&](double t) {
            return std::hypot(beside, from + t * (to - from)) - 1;
        };
        const double share = crossing_share(distance(0), distance(1), distance);
        EXPECT_NEAR(from + share * (to - from), half, 1e-3) << beside;
        EXPECT_EQ(crossing_share(0.0, 1.0, distance), 0);
    }
}

TEST(CrossingShare, AtAnEndIsNotBentByRounding)
{
    const auto noisy = [](double t) { return t - 1e-17; };
    EXPECT_NEAR(crossing_share(-1e-17, 1.0, noisy), 0, 1e-12);
    EXPECT_NEAR(crossing_share(-1.0, 1e-17, noisy), 1, 1e-12);
}

}  // namespace
}  // namespace endmill
