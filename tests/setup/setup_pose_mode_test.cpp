// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

TEST(SetupMode, IsFoundByTheWordOfTheCommandLine)
{
    EXPECT_EQ(setup_mode("paper-literal"), SetupMode::PaperLiteral);
    EXPECT_EQ(setup_mode("paper"), SetupMode::Paper);
    EXPECT_EQ(setup_mode("corrected"), SetupMode::Corrected);
    EXPECT_EQ(setup_mode("set"), SetupMode::WholeCones);
    EXPECT_EQ(setup_mode("Paper"), std::nullopt);
    EXPECT_EQ(setup_mode(""), std::nullopt);
}

TEST(PoseFitOptions, RefuseTheSearchOverWholeCones)
{
    EXPECT_THROW(check_pose_fit_options({.mode = SetupMode::WholeCones}), DomainError);
}

TEST(PoseFitOptions, RefuseLimitsThatAreReversedOrWithoutZeroOrWiderThanATurn)
{
    constexpr double pi = std::numbers::pi;
    for (const RotaryRange& bad : {RotaryRange{1, -1}, RotaryRange{0.1, 1},
                                   RotaryRange{-1, -0.1}, RotaryRange{-4, 4}}) {
        PoseFitOptions options;
        options.limits.phi = bad;
        EXPECT_THROW(check_pose_fit_options(options), DomainError);
        options.limits = {{}, bad};
        EXPECT_THROW(check_pose_fit_options(options), DomainError);
    }
    for (const RotaryRange& good :
         {RotaryRange{0, 0}, RotaryRange{0, 2 * pi}, RotaryRange{-2 * pi, 0}}) {
        PoseFitOptions options;
        options.limits.theta = good;
        EXPECT_NO_THROW(check_pose_fit_options(options));
    }
}

}  // namespace
}  // namespace endmill
