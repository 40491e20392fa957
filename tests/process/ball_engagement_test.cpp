// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/ball_engagement.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;

TEST(ShankAngle, IsClosed)
{
    EXPECT_NEAR(shank_angle({0, 0, 0.5, 2}), pi / 3, 1e-15);
    EXPECT_NEAR(shank_angle({1, 0, 0.5, 2}), std::acos(1 - 0.5 * std::cos(1)), 1e-15);
    EXPECT_EQ(shank_angle({0, 0, 3, 2}), pi);
    EXPECT_EQ(shank_angle({0, 0, 0, 2, PreviousPass::None}), pi);
    EXPECT_EQ(shank_angle({0, 0, 0, 2, PreviousPass::Edge}), pi / 2);
}

TEST(Engagement, IsAirAboveTheStockOrWithoutPickFeed)
{
    EXPECT_TRUE(is_air({0, 0, 0.5, 0}));
    EXPECT_TRUE(is_air({0, 0, 0, 1}));
    EXPECT_FALSE(is_air({0, 0, 0, 1, PreviousPass::Edge}));
    EXPECT_NO_THROW(require_sound({1.5, -1.5, 0, -4}));
}

}  // namespace
}  // namespace endmill
