// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/wide_floats.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Values = std::array<float, wide_lanes>;

constexpr Values some{1, -2,    3, 0.1F, -5e9F, std::numeric_limits<float>::infinity(),
                      0, 1e-40F};

Values stored(const WideFloats& wide)
{
    Values values;
    wide.store(values);
    return values;
}

TEST(WideFloats, AreCountedWithLaneByLane)
{
    const WideFloats wide{some.data()};
    const float third = 1.0F / 3;
    for (int k = 0; k < wide_lanes; ++k) {
        EXPECT_EQ(stored(wide + third)[k], some[k] + third);
        EXPECT_EQ(stored(wide - third)[k], some[k] - third);
        EXPECT_EQ(stored(wide * third)[k], some[k] * third);
        EXPECT_EQ(stored(wide / third)[k], some[k] / third);
        EXPECT_EQ(stored(-wide)[k], -some[k]);
        EXPECT_EQ(stored(larger(wide, third))[k], std::max(some[k], third));
        EXPECT_EQ(stored(smaller(wide, third))[k], std::min(some[k], third));
        EXPECT_EQ(stored(sign_of(wide))[k], some[k] < 0 ? -1 : 1);
        EXPECT_EQ(stored(WideFloats{})[k], 0);
    }
}

TEST(WideFloats, AreRoundedTowardsZero)
{
    std::array<std::int32_t, wide_lanes> whole{};
    const Values values{0.9F, -0.9F, 1, 2.5F, -2.5F, 1e9F, 0, -7};
    WideFloats{values.data()}.store_whole(whole);
    EXPECT_EQ(whole, (std::array<std::int32_t, 8>{0, 0, 1, 2, -2, 1000000000, 0, -7}));
}

TEST(WideBits, TellWhichLanes)
{
    const WideFloats wide{some.data()};
    EXPECT_EQ((wide > 0).bits(), 0b10101101U);
    EXPECT_EQ((wide >= 0).bits(), 0b11101101U);
    EXPECT_EQ(((wide > 0) & (wide >= 1)).bits(), 0b00100101U);
    EXPECT_EQ(((wide > 1) | (WideFloats{-1} >= wide)).bits(), 0b00110110U);
    EXPECT_TRUE((wide > 1e30F).any());
    EXPECT_TRUE((WideFloats{-1e9F} > wide).any());
    EXPECT_FALSE((WideFloats{-1e10F} > wide).any());
    const WideFloats nothing{std::nanf("")};
    EXPECT_EQ((nothing > 0).bits() | (nothing >= 0).bits(), 0U);
    const std::array<std::int32_t, wide_lanes> numbers{7, 1, 7, 3, 4, 5, 6, 7};
    EXPECT_EQ((WideBits{numbers.data(), 7}.bits()), 0b01111010U);
}

}  // namespace
}  // namespace endmill
