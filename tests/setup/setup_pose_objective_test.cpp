// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/setup_pose.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(PoseMeasure, EvaluatesItsObjective)
{
    const PoseRanges ranges{1.0, 0.5, 0.25};
    using enum SetupObjective;
    EXPECT_DOUBLE_EQ((PoseMeasure{RotaryFamily::CA, FlooredArea, 0.1})(ranges),
                     1.1 * 0.85);
    EXPECT_DOUBLE_EQ((PoseMeasure{RotaryFamily::CA, TotalRange, 0.1})(ranges), 1.75);
    EXPECT_DOUBLE_EQ((PoseMeasure{RotaryFamily::CA, Tilt, 0.1})(ranges), 0.5);
    EXPECT_DOUBLE_EQ((PoseMeasure{RotaryFamily::AB, Tilt, 0.1})({1.5, 0.5, 0.25}), 0.75);
}

TEST(PoseMeasure, ReachesATargetAtTheUsefulWidthAndHeight)
{
    using enum SetupObjective;
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        for (const SetupObjective objective : {FlooredArea, TotalRange, Tilt}) {
            const PoseMeasure measure{family, objective, 0.1};
            for (const double target : {0.4, 1.0, 2.0}) {
                const double width = measure.useful_width(target, 0.3, 0.2);
                if (width > 0 && width < 100) {
                    EXPECT_NEAR(measure({width, 0.3, 0.2}), target, 1e-12);
                }
                if (width < 100) {
                    EXPECT_GE(measure({std::max(width, 0.0), 0.3, 0.2}),
                              target * (1 - 1e-15));
                }
                if (objective == Tilt)
                    continue;
                const double height = measure.useful_height(target, 0.2);
                if (height > 0) {
                    EXPECT_NEAR(measure({0.2, height, 0}), target, 1e-12);
                }
            }
        }
    }
}

TEST(PoseRanges, TakeTheWindowFromTheFirstRotaryAxis)
{
    const FittedPose fit{.pose = {}, .phi = {-0.2, 0.5}, .theta = {-0.4, 0.1}, .area = 0};
    const PoseRanges ca = pose_ranges(RotaryFamily::CA, fit);
    EXPECT_EQ(ca.width, 0.5);
    EXPECT_EQ(ca.height(), 0.7);
    EXPECT_EQ(pose_ranges(RotaryFamily::AB, fit).width, 0.7);
}

}  // namespace
}  // namespace endmill
