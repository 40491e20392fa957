// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/detail/joint_bound.h"

#include <cmath>

#include <gtest/gtest.h>

#include "five_axis.h"
#include "random.h"

namespace endmill {
namespace {

// The bounds hold for random motions of all machines, with and without an offset between
// the axes: check [15] of docs/methods/five-axis-paths.md, section 9.
TEST(JointBound, HoldsForTheMotionOfTheTip)
{
    test::Random random{21};
    double closest = 0;
    for (int k = 0; k < 10000; ++k) {
        const PartOnMachine setup = test::random_part_on_machine(random, k % 2 == 0);
        const AxisPositions from = test::random_positions(random, 3);
        AxisPositions to = from;
        const double size = random.log_uniform(0.01, 0.8);
        for (double& rotary : to.rotary)
            rotary += random.uniform(-size, size);
        to.xyz += 30 * size * Vec3{random.uniform(-1, 1), random.uniform(-1, 1), 0};
        const CutterLocation first = tool_location(setup, from);
        const CutterLocation last = tool_location(setup, to);
        const JointBound bound = joint_bound(setup, from, to);
        const double tip_bound = bound.tip_error(middle_acceleration(setup, from, to));
        const double axis_bound = bound.axis_error(angle_between(first.axis, last.axis));
        EXPECT_LE(tip_bound, bound.tip_error(bound.second) * (1 + 1e-12));
        double tip = 0;
        double axis = 0;
        for (int i = 1; i < 40; ++i) {
            const double u = i / 40.0;
            const CutterLocation at = tool_location(setup, test::between(from, to, u));
            tip = std::max(tip, (at.tip - (1 - u) * first.tip - u * last.tip).norm());
            axis = std::max(
                axis, angle_between(at.axis, axis_on_arc(first.axis, last.axis, u)));
        }
        EXPECT_LE(tip, tip_bound + 1e-12) << setup.machine.configuration.word;
        EXPECT_LE(axis, axis_bound + 1e-12) << setup.machine.configuration.word;
        closest = std::max(closest, tip / tip_bound);
    }
    EXPECT_GT(closest, 0.8);  // the bound is not needlessly wide
}

TEST(JointBound, OfLinearMotionIsZero)
{
    test::Random random{22};
    const PartOnMachine setup = test::random_part_on_machine(random, true);
    const AxisPositions from = test::random_positions(random, 3);
    AxisPositions to = from;
    to.xyz += Vec3{10, 20, 30};
    EXPECT_EQ(joint_bound(setup, from, to).second, 0);
    EXPECT_EQ(joint_bound(setup, from, to).tip_error(0), 0);
    EXPECT_EQ(joint_bound(setup, from, to).axis_error(0), 0);
}

}  // namespace
}  // namespace endmill
