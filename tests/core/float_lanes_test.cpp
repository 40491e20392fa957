// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/detail/float_lanes.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

FloatLanes some_values()
{
    FloatLanes values;
    values << 1, -2, 3, infinity, -infinity, 3, 0, -0.0F;
    return values;
}

TEST(FloatLanes, TellsWhichAreNotBelowALimit)
{
    EXPECT_EQ(lanes_not_below(3, some_values()), 0b00101100U);
    EXPECT_EQ(lanes_not_below(0, some_values()), 0b11101101U);
    EXPECT_EQ(lanes_not_below(-infinity, some_values()), 0b11111111U);
    EXPECT_EQ(lanes_not_below(infinity, some_values()), 0b00001000U);
}

TEST(FloatLanes, KeepsTheValuesOfSmallKeys)
{
    FloatLanes keys;
    keys << 0, 1, 2, 3, 4, 2, 2.0000002F, -1;
    const FloatLanes kept = kept_up_to(2, keys, some_values());
    for (int k = 0; k < float_lanes; ++k)
        EXPECT_EQ(kept[k], keys[k] <= 2 ? some_values()[k] : -infinity);
}

TEST(WideLanes, AreCountedWithLaneByLane)
{
    FloatLanes values;
    values << 1, -2, 3, 0.1F, -5e9F, 3, 0, 1e-40F;
    const WideLanes wide{values};
    const WideLanes third{1.0F / 3};
    const FloatLanes sum = (wide + third).lanes();
    const FloatLanes difference = (wide - third).lanes();
    const FloatLanes product = (wide * third).lanes();
    const FloatLanes most = larger(wide, third).lanes();
    const FloatLanes least = smaller(wide, third).lanes();
    for (int k = 0; k < float_lanes; ++k) {
        EXPECT_EQ(sum[k], values[k] + 1.0F / 3);
        EXPECT_EQ(difference[k], values[k] - 1.0F / 3);
        EXPECT_EQ(product[k], values[k] * (1.0F / 3));
        EXPECT_EQ(most[k], std::max(values[k], 1.0F / 3));
        EXPECT_EQ(least[k], std::min(values[k], 1.0F / 3));
    }
}

TEST(WideLanes, KnowInfinity)
{
    const WideLanes wide{some_values()};
    const FloatLanes least = smaller(wide, WideLanes{infinity}).lanes();
    for (int k = 0; k < float_lanes; ++k)
        EXPECT_EQ(least[k], some_values()[k]);
    EXPECT_TRUE((larger(wide, WideLanes{infinity}).lanes() == infinity).all());
}

}  // namespace
}  // namespace endmill
