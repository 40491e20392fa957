// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/bound/detail/interval_arithmetic.h"

#include <random>

#include <gtest/gtest.h>

namespace endmill {
namespace {

struct Sample {
    Interval range;
    double number;
};

Sample sample(std::mt19937_64& engine)
{
    std::uniform_real_distribution<double> uniform{-2, 2};
    const double a = uniform(engine);
    const double b = uniform(engine);
    std::uniform_real_distribution<double> inside{0, 1};
    const Interval range{std::min(a, b), std::max(a, b)};
    return {range, std::lerp(range.low, range.high, inside(engine))};
}

TEST(IntervalArithmetic, ContainsTheResultsOfRandomNumbers)
{
    std::mt19937_64 engine{1};
    for (int k = 0; k < 20000; ++k) {
        const Sample a = sample(engine);
        const Sample b = sample(engine);
        constexpr double e = 1e-14;  // rounding is not included
        const auto holds = [&](const Interval& range, double number) {
            return range.low - e <= number && number <= range.high + e;
        };
        EXPECT_TRUE(holds(a.range + b.range, a.number + b.number));
        EXPECT_TRUE(holds(a.range - b.range, a.number - b.number));
        EXPECT_TRUE(holds(a.range * b.range, a.number * b.number));
        EXPECT_TRUE(holds(b.number * a.range, a.number * b.number));
        EXPECT_TRUE(holds(-a.range, -a.number));
        EXPECT_TRUE(holds(square(a.range), a.number * a.number));
        EXPECT_TRUE(holds(hull(a.range, b.range), a.number));
        EXPECT_LE(std::abs(a.number), magnitude(a.range));
        if (!contains(a.range, 0)) {
            EXPECT_TRUE(holds(a.range * reciprocal(a.range), 1));
        }
        if (a.number >= 0) {
            EXPECT_TRUE(holds(square_root(a.range), std::sqrt(a.number)));
        }
    }
}

TEST(IntervalArithmetic, HasExactEnds)
{
    const Interval product = Interval{-1, 2} * Interval{-3, 5};
    EXPECT_EQ(product.low, -6);
    EXPECT_EQ(product.high, 10);
    EXPECT_EQ(square(Interval{-1, 2}).low, 0);
    EXPECT_TRUE(std::isinf(reciprocal(Interval{-1, 2}).high));
    EXPECT_TRUE(contains(around_zero(2), Interval{-1, 2}));
    EXPECT_FALSE(contains(around_zero(2), Interval{-1, 2.1}));
    EXPECT_EQ(common_part(Interval{-1, 2}, Interval{0, 3}).low, 0);
}

}  // namespace
}  // namespace endmill
