// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/rounded_degrees.h"

#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(RoundedDegrees, IsTheWholeNumberOfTheAngle)
{
    for (int degrees = -720; degrees <= 720; ++degrees)
        EXPECT_EQ(rounded_degrees(Angle::degrees(degrees).radians()), degrees);
}

TEST(RoundedDegrees, IsOffByHalfAStepAtMost)
{
    for (const double radians : {0.1, 1.23456789, -2.5, 1e-9})
        EXPECT_NEAR(rounded_degrees(radians), radians * 180 / std::numbers::pi, 0.51e-9);
}

}  // namespace
}  // namespace endmill
