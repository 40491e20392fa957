// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/engagement.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(BallFront, OfNothingHasNoCells)
{
    const BallFront front;
    EXPECT_TRUE(front.engaged.empty());
    EXPECT_TRUE(front.shank.empty());
    EXPECT_EQ(front.rim_angle, 0);
}

}  // namespace
}  // namespace endmill
