// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/lanes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using Values = std::array<float, float_lanes>;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr Values some{1, -2, 3, 0.1F, -5e9F, infinity, 0, 1e-40F};

// With equal values, both infinities and both zeros.
FloatLanes special_values()
{
    FloatLanes values;
    values << 1, -2, 3, infinity, -infinity, 3, 0, -0.0F;
    return values;
}

Values stored(const WideFloats& wide)
{
    Values values;
    wide.store(values);
    return values;
}

TEST(FloatLanes, AreComparedWithALimitLaneByLane)
{
    EXPECT_EQ(lanes_not_below(3, special_values()), 0b00101100U);
    EXPECT_EQ(lanes_not_below(0, special_values()), 0b11101101U);
    EXPECT_EQ(lanes_not_below(-infinity, special_values()), 0b11111111U);
    EXPECT_EQ(lanes_not_below(infinity, special_values()), 0b00001000U);
}

TEST(FloatLanes, AreKeptWhereTheirKeysAreSmall)
{
    FloatLanes keys;
    keys << 0, 1, 2, 3, 4, 2, 2.0000002F, -1;
    const FloatLanes kept = kept_up_to(2, keys, special_values());
    for (int k = 0; k < float_lanes; ++k)
        EXPECT_EQ(kept[k], keys[k] <= 2 ? special_values()[k] : -infinity);
}

TEST(WideFloats, ComputeLikeSingleFloatsInEachLane)
{
    const WideFloats wide{some.data()};
    const float third = 1.0F / 3;
    for (int k = 0; k < float_lanes; ++k) {
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

TEST(WideFloats, ReadAndWriteFloatLanes)
{
    const FloatLanes values = special_values();
    const WideFloats wide{values};
    const FloatLanes back = wide.lanes();
    for (int k = 0; k < float_lanes; ++k) {
        EXPECT_EQ(back[k], values[k]);
        EXPECT_EQ(std::signbit(back[k]), std::signbit(values[k]));
    }
    const FloatLanes least = smaller(wide, WideFloats{infinity}).lanes();
    for (int k = 0; k < float_lanes; ++k)
        EXPECT_EQ(least[k], values[k]);
    EXPECT_TRUE((larger(wide, WideFloats{infinity}).lanes() == infinity).all());
}

TEST(WideFloats, AreRoundedTowardsZero)
{
    std::array<std::int32_t, float_lanes> whole{};
    const Values values{0.9F, -0.9F, 1, 2.5F, -2.5F, 1e9F, 0, -7};
    WideFloats{values.data()}.store_whole(whole);
    EXPECT_EQ(whole, (std::array<std::int32_t, 8>{0, 0, 1, 2, -2, 1000000000, 0, -7}));
}

TEST(WideBits, NameTheLanesInWhichAComparisonHolds)
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
    const std::array<std::int32_t, float_lanes> numbers{7, 1, 7, 3, 4, 5, 6, 7};
    EXPECT_EQ((WideBits{numbers.data(), 7}.bits()), 0b01111010U);
}

}  // namespace
}  // namespace endmill
