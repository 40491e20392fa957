// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/exact_arithmetic.h"

#include <gtest/gtest.h>

#include "random.h"

namespace endmill {
namespace {

// 2^53 + 1 and 2^104 - 1 have more digits than a double holds.
TEST(DoubleDouble, KeepsTwiceTheDigits)
{
    const double big = 9007199254740992;
    EXPECT_EQ((DoubleDouble{big} + 1 - big).value(), 1);
    const double half = big / 2;
    EXPECT_EQ((DoubleDouble{half + 1} * (half - 1) - half * half).value(), -1);
}

TEST(DoubleDouble, UndoesWhatItDoes)
{
    test::Random random{1};
    for (int k = 0; k < 1000; ++k) {
        const DoubleDouble a = DoubleDouble{random.log_uniform(1e-9, 1e9)} / 3;
        const DoubleDouble b = DoubleDouble{random.uniform(-5, 5)} / 7;
        EXPECT_NEAR((a / b * b - a).value(), 0, 1e-30 * a.value());
        EXPECT_NEAR((sqrt(a) * sqrt(a) - a).value(), 0, 1e-30 * a.value());
        EXPECT_NEAR((a + b - a - b).value(), 0, 1e-30 * (a.value() + 1));
    }
}

TEST(DoubleDouble, ComparesBeyondTheDigitsOfADouble)
{
    const DoubleDouble more = DoubleDouble{1} + 1e-25;
    EXPECT_TRUE(more > 1 && DoubleDouble{1} < more && !(more <= 1) && more >= 1);
    EXPECT_EQ(more.value(), 1);
    EXPECT_EQ(sqrt(DoubleDouble{-1}).value(), 0);
}

}  // namespace
}  // namespace endmill
