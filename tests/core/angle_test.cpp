// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/core/angle.h"

#include <cmath>

#include <gtest/gtest.h>

namespace endmill {
namespace {

static_assert(Angle::degrees(180).radians() == std::numbers::pi);
static_assert(Angle::radians(std::numbers::pi / 2).degrees() == 90);

TEST(Angle, OfThirtyDegreesHasASineOfOneHalf)
{
    EXPECT_NEAR(std::sin(Angle::degrees(30).radians()), 0.5, 1e-16);
    EXPECT_NEAR(std::sin(Angle::degrees(-30).radians()), -0.5, 1e-16);
}

TEST(Angle, ReturnsItsValueInBothUnits)
{
    for (const double value : {-720.0, -1e-9, 0.0, 1e-300, 0.1, 45.0, 1e6}) {
        EXPECT_EQ(Angle::radians(value).radians(), value);
        EXPECT_NEAR(Angle::degrees(value).degrees(), value, 3e-16 * std::abs(value));
    }
}

TEST(Angle, InDegreesIsAsWritten)
{
    int longer = 0;
    for (int tenths = -3600; tenths <= 3600; ++tenths) {
        const double written = tenths / 10.0;
        EXPECT_EQ(Angle::degrees(written).written_degrees(), written);
        longer += Angle::degrees(written).degrees() != written ? 1 : 0;
    }
    EXPECT_GT(longer, 0);
    const Angle third = Angle::radians(1.0 / 3);
    EXPECT_EQ(third.written_degrees(), third.degrees());
}

}  // namespace
}  // namespace endmill
