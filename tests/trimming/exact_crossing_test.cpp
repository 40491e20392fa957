// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/trimming/detail/exact_crossing.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace endmill {
namespace {

const SectionLine rising{{0, 0}, {3, 1}};    // z = s / 3
const SectionLine falling{{0, 1}, {1, 0}};   // z = 1 - s; the lines cross in (3/4, 1/4)
const SectionLine backward{{1, 0}, {0, 1}};  // the same line
constexpr double tiny = 0x1p-52;

TEST(ExactCrossing, DecidesSidesAtTheLastBit)
{
    const SectionLine level{{-1, 0.25}, {5, 0.25}};
    const SectionLine above{{-1, 0.25}, {5, 0.25 + tiny}};
    for (const SectionLine& other : {falling, backward}) {
        EXPECT_EQ(exact_side(level, rising, other), 0);
        EXPECT_EQ(exact_side(above, rising, other), -1);
        EXPECT_EQ(exact_order(rising, other, 0.75), 0);
        EXPECT_EQ(exact_order(rising, other, 0.75 - tiny), 1);
        EXPECT_EQ(exact_order(rising, other, 0.75 + tiny), -1);
        EXPECT_EQ(exact_height_order(rising, other, 0.75), 0);
        EXPECT_EQ(exact_height_order(rising, other, 0.75 + tiny), 1);
        EXPECT_EQ(exact_height_order(rising, other, 0.75 - tiny), -1);
    }
    EXPECT_EQ(exact_order(rising, falling, level, {{0, 1}, {0.75, 0.25}}), 0);
    EXPECT_EQ(exact_order(rising, falling, above, falling), 1);
    EXPECT_EQ(exact_order(above, falling, rising, falling), -1);
}

// A coordinate that is a double is returned exactly; a third is rounded as the division
// rounds it.
TEST(ExactCrossing, IsRoundedToTheNearestDouble)
{
    EXPECT_EQ(exact_crossing(rising, falling), SectionPoint(0.75, 0.25));
    for (const double numerator : {1.0, 2.0, -5.0, 1e300, 3e-308, 7 * 0x1p-1074})
        EXPECT_EQ(exact_height({{0, 0}, {3, numerator}}, 1), numerator / 3);
    // Half of an odd multiple of the smallest double is rounded to even.
    for (const double odd : {1.0, 3.0, 5.0, -7.0})
        EXPECT_EQ(exact_height({{0, 0}, {2, odd * 0x1p-1074}}, 1), odd * 0x1p-1074 / 2);
    EXPECT_EQ(exact_height({{0, 0}, {1, 1}}, 0), 0);
}

TEST(ExactCrossing, HoldsForCoordinatesOfAnySize)
{
    constexpr double large = std::numeric_limits<double>::max();
    constexpr double small = std::numeric_limits<double>::denorm_min();
    const SectionLine up{{-large, -large}, {large, large}};
    const SectionLine down{{-small, small}, {small, -small}};
    EXPECT_EQ(exact_crossing(up, down), SectionPoint(0, 0));
    EXPECT_EQ(exact_side({{-large, 0}, {large, small}}, up, down), -1);
    EXPECT_EQ(exact_height_order(up, down, small), 1);
}

}  // namespace
}  // namespace endmill
