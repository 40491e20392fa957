// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/several_setups.h"

#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"
#include "plain_reach.h"

namespace endmill {
namespace {

// Against the angles of each cell, one turn after the other.
void expect_those_that_fit(const SetupReach& reach, std::span<const Vec3> centres,
                           std::size_t pole)
{
    const auto runs = feasible_turns(reach, centres, pole);
    for (std::size_t turn = 0; turn < turns_about_tool_axis; ++turn) {
        const RotaryFrame frame = frame_at(reach, centres[pole], turn);
        std::vector<int> held(centres.size(), 0);
        for (const FeasibleTurns& run : runs)
            held[run.cell] += run.hold(turn) ? 1 : 0;
        for (std::size_t cell = 0; cell < held.size(); ++cell) {
            // Opposite to the tool axis rounding chooses the turn of C.
            if (centres[cell].dot(centres[pole]) < -1 + 1e-12)
                continue;
            const bool expected =
                cell == pole ||
                (reach.axes > 3 && test::takes(reach, frame, centres[cell]));
            ASSERT_EQ(held[cell], expected ? 1 : 0) << pole << ' ' << cell;
        }
    }
}

TEST(SetupReach, HasTheTurnsFromWhichTheAnglesFitTheLimits)
{
    const SphereGrid grid = sphere_grid("hex:2");
    for (const SetupReach& reach : test::reaches())
        for (std::size_t pole = 0; pole < grid.centres.size(); pole += 7)
            expect_those_that_fit(reach, grid.centres, pole);
}

// Cells at whole multiples of the step from a pole in the equator of others.
TEST(SetupReach, HoldsWhatLiesAtTheLimits)
{
    std::vector<Vec3> centres{Vec3::UnitZ()};
    for (int k = 0; k < 72; ++k) {
        const double azimuth = 2 * std::numbers::pi * k / 72;
        centres.push_back(
            {0.5 * std::cos(azimuth), 0.5 * std::sin(azimuth), std::sqrt(0.75)});
    }
    const double step = 2 * std::numbers::pi / 72;
    const double tilt = std::numbers::pi / 6;
    const SetupReach reach{.limits = {{0, tilt}, {-2 * step, 3 * step}}};
    const auto runs = feasible_turns(reach, centres, 0);
    ASSERT_EQ(runs.size(), 73U);
    for (std::size_t k = 1; k < runs.size(); ++k)
        EXPECT_EQ(runs[k].count, 6);
}

TEST(SetupReach, OppositeToTheToolAxisAnyTurnOfCDoesIfTheTiltGoesSoFar)
{
    const std::vector<Vec3> centres{Vec3::UnitX(), -Vec3::UnitX()};
    SetupReach reach{.limits = {{}, {-0.1, 0.1}}};
    EXPECT_EQ(feasible_turns(reach, centres, 0).size(), 2U);
    EXPECT_EQ(feasible_turns(reach, centres, 0)[1].count, turns_about_tool_axis);
    reach.limits.phi = {-3, 3};
    EXPECT_EQ(feasible_turns(reach, centres, 0).size(), 1U);
}

TEST(SetupReach, FramesAreRightHandedAndFiveDegreesApart)
{
    const Vec3 axis = Vec3{1, 2, 3}.normalized();
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const SetupReach reach{.family = family};
        const RotaryFrame one = frame_at(reach, axis, 10);
        const RotaryFrame next = frame_at(reach, axis, 11);
        EXPECT_EQ(one.tool_axis, axis);
        EXPECT_NEAR(one.r2_axis.dot(axis), 0, 1e-15);
        EXPECT_NEAR(one.r2_axis.dot(next.r2_axis), std::cos(std::numbers::pi / 36),
                    1e-15);
        EXPECT_GT(one.r2_axis.cross(next.r2_axis).dot(axis), 0);
    }
}

}  // namespace
}  // namespace endmill
