// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(SetupPose, IsFoundNowhereBeforeASearch)
{
    const SetupSearch search;
    EXPECT_EQ(search.status, SetupStatus::Ok);
    EXPECT_FALSE(search.least);
    EXPECT_FALSE(search.feasible);
    EXPECT_EQ(search.poses_tried, 0U);
    EXPECT_EQ(search.poses_skipped, 0U);
}

TEST(SetupPose, FitsAsARigidPartUnlessSaid)
{
    const FittedPose fit{};
    EXPECT_TRUE(fit.is_rigid);
    EXPECT_EQ(fit.cell, 0U);
    EXPECT_EQ(fit.area, 0);
    EXPECT_EQ(fit.phi, RotaryRange{});
}

}  // namespace
}  // namespace endmill
