// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/detail/round_ticks.h"

#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(RoundTicks, CoverTheRangeByRoundSteps)
{
    EXPECT_EQ(round_ticks(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_EQ(round_ticks(-3, 7, 4), (std::vector<double>{-5, 0, 5, 10}));
    for (const auto& [low, high] :
         {std::pair{3.3, 3.3}, std::pair{-1e6, 1e6}, std::pair{1e-7, 3e-7},
          std::pair{0.0, 0.0}, std::pair{1e9, 1e9 + 1}}) {
        const std::vector<double> ticks = round_ticks(low, high, 4);
        ASSERT_GE(ticks.size(), 2u);
        EXPECT_LE(ticks.front(), low);
        EXPECT_GE(ticks.back(), high);
        EXPECT_LE(ticks.size(), 8u);
    }
}

TEST(TicksWithin, LieInTheRange)
{
    EXPECT_EQ(ticks_within(-3, 7, 4), (std::vector<double>{0, 5}));
    EXPECT_EQ(ticks_within(0, 10, 5), (std::vector<double>{0, 2, 4, 6, 8, 10}));
    EXPECT_TRUE(ticks_within(0.1, 0.2, 1).size() <= 2);
}

TEST(TickText, HasTheDigitsOfTheStep)
{
    EXPECT_EQ(tick_text(0.30000000000000004, 0.1), "0.3");
    EXPECT_EQ(tick_text(-20, 10), "-20");
    EXPECT_EQ(tick_text(-0.0, 10), "0");
    EXPECT_EQ(step_of({1, 3, 5}), 2);
    EXPECT_EQ(step_of({1}), 1);
}

}  // namespace
}  // namespace endmill
