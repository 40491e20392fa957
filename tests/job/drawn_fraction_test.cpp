// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/drawn_fraction.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

namespace endmill {
namespace {

// python3 -c 'import hashlib; print((int.from_bytes(hashlib.sha256(b"7/scallop/12").digest()[:8],
// "big") >> 11) / 2**53)'
TEST(DrawnFraction, IsThatOfAnIndependentComputation)
{
    EXPECT_EQ(drawn_fraction(7, "scallop", 12), 0.4937885127926751);
    EXPECT_EQ(drawn_fraction(0, "cutter", 9'999'999), 0.6185533997933875);
}

// The mean of n uniform numbers has the standard deviation 1 / sqrt(12 n).
TEST(DrawnFraction, IsUniform)
{
    constexpr int count = 20'000;
    double sum = 0;
    double squares = 0;
    for (int i = 0; i < count; ++i) {
        const double share = drawn_fraction(1, "x", i);
        ASSERT_GE(share, 0);
        ASSERT_LT(share, 1);
        sum += share;
        squares += share * share;
    }
    EXPECT_NEAR(sum / count, 0.5, 4 / std::sqrt(12.0 * count));
    EXPECT_NEAR(squares / count, 1.0 / 3, 4 * std::sqrt(4.0 / 45 / count));
}

TEST(DrawnFraction, DependsOnSeedKeyAndCase)
{
    const double share = drawn_fraction(1, "x", 1);
    EXPECT_NE(share, drawn_fraction(2, "x", 1));
    EXPECT_NE(share, drawn_fraction(1, "y", 1));
    EXPECT_NE(share, drawn_fraction(1, "x", 2));
}

// The power by the library's logarithm, in higher precision.
TEST(GeometricBetween, IsThePowerOfTheShare)
{
    for (int i = 0; i < 1000; ++i) {
        const double share = drawn_fraction(3, "x", i);
        for (const auto& [low, high] :
             {std::pair{0.01, 0.5}, {1e-9, 1e9}, {3.0, 3.0000001}, {2.0, 2.0}}) {
            const long double power = low * std::pow(static_cast<long double>(high) / low,
                                                     static_cast<long double>(share));
            EXPECT_NEAR(geometric_between(low, high, share) / power, 1, 1e-13);
        }
    }
    EXPECT_EQ(geometric_between(0.25, 4, 0), 0.25);
    EXPECT_EQ(geometric_between(0.25, 4, 0.5), 1);
}

}  // namespace
}  // namespace endmill
