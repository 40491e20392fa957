// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/drop_cutter/detail/concave_bound.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The minimum of several lines. Its maximum is where two of them cross or at an end; all
// candidates are tested.
struct Lines {
    std::array<double, 4> height;
    std::array<double, 4> slope;

    double at(double x) const
    {
        double least = infinite;
        for (std::size_t k = 0; k < height.size(); ++k)
            least = std::min(least, height[k] + slope[k] * x);
        return least;
    }

    double greatest() const
    {
        double greatest = std::max(at(0), at(1));
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const double x = (height[j] - height[i]) / (slope[i] - slope[j]);
                if (0 < x && x < 1)
                    greatest = std::max(greatest, at(x));
            }
        return greatest;
    }
};

TEST(ConcaveBound, IsNeverWrongAndMostlyDecides)
{
    test::Random random{1};
    int undecided = 0;
    for (int k = 0; k < 2000; ++k) {
        Lines lines;
        for (std::size_t i = 0; i < 4; ++i) {
            lines.height[i] = random.uniform(-1, 1);
            lines.slope[i] = random.uniform(-3, 3);
        }
        const double limit = random.uniform(-1, 1);
        const bool is_below = stays_below([&](double x) { return lines.at(x); }, limit);
        if (is_below) {
            EXPECT_LE(lines.greatest(), limit + 1e-12);
        } else {
            undecided += lines.greatest() <= limit;
        }
    }
    EXPECT_LT(undecided, 20);
}

TEST(ConcaveBound, SeesAParabolaBetweenItsValues)
{
    const auto parabola = [](double x) { return 1 - (x - 0.37) * (x - 0.37); };
    EXPECT_TRUE(stays_below(parabola, 1.001));
    EXPECT_FALSE(stays_below(parabola, 0.9999));
}

TEST(ConcaveBound, IsUndecidedWithoutAValue)
{
    const auto part = [](double x) { return x > 0.9 ? -1.0 : -infinite; };
    EXPECT_FALSE(stays_below(part, -2));
    EXPECT_FALSE(stays_below([](double) { return -infinite; }, 0));
}

}  // namespace
}  // namespace endmill
