// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/setup/detail/sampled_poses.h"
#include "endmill/setup/setup.h"
#include "endmill/setup/setup_travel.h"
#include "plane_part.h"

// The search for a setup that the linear axes reach.
namespace endmill {
namespace {

using test::machine_of;
using test::PlanePart;

const Clamping within{.travel = TravelRule::WithinLimits};

// On a machine of three axes the tool axis is a cell centre n. The centroids differ by d
// = (90, 30, 0), of which z takes d . n and the plane across n the rest, in any
// direction. A pose fits if that direction can be turned into the rectangle of x and y.
TEST(SetupWithinTravel, TurnsAPlaneIntoTheTravelOfThreeAxes)
{
    const PlanePart plane;
    Machine machine = machine_of("W/xyBz/T");
    machine.linear = {LinearRange{0, 40}, {0, 95}, {0, 45}};
    const MachineSetup found = machine_setup(plane.part(), machine, {}, within);
    EXPECT_EQ(found.within_travel, Answer::Yes);
    EXPECT_TRUE(found.is_machinable());
    ASSERT_TRUE(found.travel_search && found.travel && found.part_to_machine);
    const Vec3 width =
        (*found.part_to_machine * Vec3{90, 30, 0}).cwiseAbs();  // of the travel
    EXPECT_LT((found.travel->high - found.travel->low - width).norm(), 1e-9);
    const Vec3 room{40, 95, 45};
    EXPECT_LT((found.travel_search->clamping->slack - (room - width) / 2).norm(), 1e-5);
    EXPECT_EQ(found.clamp, found.travel_search->clamping->clamp);
    EXPECT_TRUE(found.travel->is_within);
}

// No turn makes the travel shorter than |d|: x and y need |d across n| together. The best
// pose of all samples is found by trying them here.
TEST(SetupWithinTravel, StatesByHowMuchTheNearestPoseExceedsTheTravel)
{
    const PlanePart plane;
    Machine machine = machine_of("W/xyBz/T");
    machine.linear = {LinearRange{-10, 10}, {-20, 25}, {-30, 0}};
    const Vec3 room{20, 45, 30};
    const MachineSetup found = machine_setup(plane.part(), machine, {}, within);
    EXPECT_EQ(found.within_travel, Answer::No);
    EXPECT_FALSE(found.is_machinable());
    EXPECT_EQ(found.best.machinable, Answer::Yes);
    EXPECT_EQ(setup_rank(found, 5).machinable, Answer::No);
    ASSERT_TRUE(found.travel_search && found.travel_search->clamping);
    const auto poses =
        sampled_poses(plane.grid, plane.visibility,
                      {{machine.configuration, machine.rotary}, SetupMode::Paper});
    EXPECT_EQ(found.travel_search->poses, poses.size());
    double greatest = -std::numeric_limits<double>::infinity();
    for (const FittedPose& fit : poses) {
        const Vec3 width =
            (part_to_machine(fit.pose, machine.configuration) * Vec3{90, 30, 0})
                .cwiseAbs();
        greatest = std::max(greatest, ((room - width) / 2).minCoeff());
    }
    EXPECT_LT(greatest, 0);
    EXPECT_NEAR(found.travel_search->clamping->least_slack(), greatest, 1e-6);
}

TEST(SetupWithinTravel, KeepsTheBestPoseWhereItFits)
{
    const PlanePart plane;
    for (const char* word : {"W/xyBz/T", "W/axyBz/T", "W/caxyBz/T", "W/xyBzab/T"}) {
        Machine machine = machine_of(word);
        machine.linear.fill({-500, 500});
        const MachineSetup free = machine_setup(plane.part(), machine, {}, Clamping{});
        const MachineSetup found = machine_setup(plane.part(), machine, {}, within);
        EXPECT_EQ(found.travel_search->poses, 1U) << word;
        EXPECT_TRUE(is_same_pose(found.best.feasible->pose, free.best.feasible->pose));
        EXPECT_TRUE(found.is_machinable()) << word;
    }
}

// A given clamping position is not changed. 100 mm beside the travel no pose fits.
TEST(SetupWithinTravel, KeepsAGivenClamping)
{
    const PlanePart plane;
    Machine machine = machine_of("W/xyBz/T");
    machine.linear.fill({-100, 100});
    Clamping given = within;
    given.origin = Vec3{0, 0, 0};
    EXPECT_EQ(machine_setup(plane.part(), machine, {}, given).within_travel, Answer::Yes);
    given.origin = Vec3{0, 0, 200};
    const MachineSetup far = machine_setup(plane.part(), machine, {}, given);
    EXPECT_EQ(far.within_travel, Answer::No);
    EXPECT_EQ(far.travel_search->clamping->clamp, *given.origin);
    EXPECT_LE(far.travel_search->clamping->slack.z(), -100 + 90 * std::sin(0.44) + 1e-9);
}

TEST(SetupWithinTravel, NeedsLinearLimitsAndAFeasiblePose)
{
    const PlanePart plane;
    EXPECT_FALSE(
        machine_setup(plane.part(), machine_of("W/xyBz/T"), {}, within).travel_search);
    PlanePart unreachable;
    unreachable.visibility.map = VisibilityMap{2, unreachable.grid.centres.size()};
    Machine machine = machine_of("W/caxyBz/T");
    machine.linear[0] = {-1, 1};
    const MachineSetup none = machine_setup(unreachable.part(), machine, {}, within);
    EXPECT_FALSE(none.travel_search);
    EXPECT_EQ(none.within_travel, Answer::Undecided);
}

}  // namespace
}  // namespace endmill
