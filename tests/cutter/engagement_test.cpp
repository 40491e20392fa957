// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/engagement.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;

// Rings all around a half sphere of radius 5; their strips add up to its area, 2 pi R^2.
TEST(EngagedArea, OfAllRingsIsThatOfTheCutter)
{
    constexpr int rings = 400;
    constexpr double step = pi / 2 / rings;
    Engagement engagement;
    for (int k = 0; k < rings; ++k) {
        const double latitude = (k + 0.5) * step;
        engagement.rings.push_back({.latitude = latitude,
                                    .radius = 5 * std::sin(latitude),
                                    .above = 5 - 5 * std::cos(latitude),
                                    .width = 5 * step,
                                    .engaged = {{-pi, 0}, {0, pi}}});
    }
    EXPECT_NEAR(engaged_area(engagement), 2 * pi * 25, 1e-3);
}

TEST(EngagedArea, OfNothingIsZero)
{
    EXPECT_EQ(engaged_area({}), 0);
}

}  // namespace
}  // namespace endmill
