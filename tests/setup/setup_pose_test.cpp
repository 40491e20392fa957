// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(SetupPose, IsMissingBeforeASearch)
{
    const PoseSearchResult search;
    EXPECT_EQ(search.status, SetupStatus::Ok);
    EXPECT_FALSE(search.least);
    EXPECT_FALSE(search.feasible);
    EXPECT_EQ(search.poses_tried, 0U);
    EXPECT_EQ(search.poses_skipped, 0U);
}

TEST(FittedPose, BelongsToARigidPartByDefault)
{
    const FittedPose fit{};
    EXPECT_TRUE(fit.is_rigid);
    EXPECT_EQ(fit.cell, 0U);
    EXPECT_EQ(fit.area, 0);
    EXPECT_EQ(fit.phi, RotaryRange{});
}

TEST(Magnitudes, AreSortedWhicheverEndIsLarger)
{
    EXPECT_EQ(magnitudes({-0.2, 0.5}), (std::array{0.2, 0.5}));
    EXPECT_EQ(magnitudes({-0.4, 0.1}), (std::array{0.1, 0.4}));
    EXPECT_EQ(magnitudes({0, 0}), (std::array{0.0, 0.0}));
}

TEST(MachineConfiguration, HasBFirstOnlyInWordsOfBThenA)
{
    for (const char* word : {"W/baBxyz/T", "W/bxyBza/T"})
        EXPECT_EQ(rotary_order(configuration_from_word(word)), RotaryOrder::BFirst)
            << word;
    for (const char* word :
         {"W/abBxyz/T", "W/cbBxyz/T", "W/bBxyz/T", "W/bcBxyz/T", "W/xyBz/T"})
        EXPECT_EQ(rotary_order(configuration_from_word(word)), RotaryOrder::AFirst)
            << word;
}

TEST(PoseFrame, HasTheAxesOfThePoseAndTheFamilyOfTheMachine)
{
    const SetupPose pose{Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()};
    const RotaryFrame four = pose_frame(configuration_from_word("W/aBxyz/T"), pose);
    EXPECT_EQ(four.family, RotaryFamily::AB);
    EXPECT_EQ(four.tool_axis, pose.tool_axis);
    EXPECT_EQ(four.r1_axis, pose.r1_axis);
    EXPECT_EQ(four.r2_axis, pose.r2_axis);
    EXPECT_EQ(pose_frame(configuration_of_family(RotaryFamily::CA), pose).family,
              RotaryFamily::CA);
}

TEST(ReachLimits, GiveTheArcToleranceToFourAxesAndNoneToThree)
{
    RotaryReach reach{.limits = {{-1, 2}, {-0.5, 0.5}},
                      .arc_tolerance = Angle::radians(0.1)};
    reach.configuration = configuration_of_family(RotaryFamily::AB);
    EXPECT_EQ(reach_limits(reach), reach.limits);
    reach.configuration = configuration_from_word("W/aBxyz/T");
    EXPECT_EQ(reach_limits(reach), (RotaryLimits{{-1, 2}, {-0.1, 0.1}}));
    reach.configuration = configuration_from_word("W/xyBz/T");
    EXPECT_EQ(reach_limits(reach), (RotaryLimits{{-1, 2}, {0, 0}}));
}

}  // namespace
}  // namespace endmill
