// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/feasible_turns.h"

#include <span>
#include <vector>

#include <gtest/gtest.h>

#include "endmill/visibility/sphere_grid.h"
#include "turns_by_angles.h"

namespace endmill {
namespace {

// Compares the runs with the angles of each cell, one turn after the other.
void expect_turns_that_fit(const RotaryReach& reach, std::span<const Vec3> centres,
                           std::size_t pole)
{
    const auto runs = feasible_turns(reach, centres, pole);
    for (std::size_t turn = 0; turn < turns_about_tool_axis; ++turn) {
        const RotaryFrame frame = frame_at(reach, centres[pole], turn);
        std::vector<int> held(centres.size(), 0);
        for (const FeasibleTurns& run : runs)
            held[run.cell] += run.hold(turn) ? 1 : 0;
        for (std::size_t cell = 0; cell < held.size(); ++cell) {
            // Opposite to the tool axis the turn of C is a result of rounding.
            if (centres[cell].dot(centres[pole]) < -1 + 1e-12)
                continue;
            const bool expected =
                cell == pole || (!reach.configuration.rotary.empty() &&
                                 test::takes(reach, frame, centres[cell]));
            ASSERT_EQ(held[cell], expected ? 1 : 0) << pole << ' ' << cell;
        }
    }
}

TEST(FeasibleTurns, AreThoseFromWhichTheAnglesFitTheLimits)
{
    const SphereGrid grid = sphere_grid("hex:2");
    for (const RotaryReach& reach : test::reaches())
        for (std::size_t pole = 0; pole < grid.centres.size(); pole += 7)
            expect_turns_that_fit(reach, grid.centres, pole);
}

// The cells lie on a parallel about the pole, at multiples of the step of 5 degrees.
TEST(FeasibleTurns, HoldCellsAtTheLimits)
{
    std::vector<Vec3> centres{Vec3::UnitZ()};
    for (int k = 0; k < 72; ++k) {
        const double azimuth = 2 * std::numbers::pi * k / 72;
        centres.push_back(
            {0.5 * std::cos(azimuth), 0.5 * std::sin(azimuth), std::sqrt(0.75)});
    }
    const double step = 2 * std::numbers::pi / 72;
    const double tilt = std::numbers::pi / 6;
    const RotaryReach reach{.configuration = configuration_of_family(RotaryFamily::CA),
                            .limits = {{0, tilt}, {-2 * step, 3 * step}}};
    const auto runs = feasible_turns(reach, centres, 0);
    ASSERT_EQ(runs.size(), 73U);
    for (std::size_t k = 1; k < runs.size(); ++k)
        EXPECT_EQ(runs[k].count, 6);
}

TEST(FeasibleTurns, AreAllOppositeToTheToolAxisIfTheTiltGoesThatFar)
{
    const std::vector<Vec3> centres{Vec3::UnitX(), -Vec3::UnitX()};
    RotaryReach reach{.configuration = configuration_of_family(RotaryFamily::CA),
                      .limits = {{}, {-0.1, 0.1}}};
    EXPECT_EQ(feasible_turns(reach, centres, 0).size(), 2U);
    EXPECT_EQ(feasible_turns(reach, centres, 0)[1].count, turns_about_tool_axis);
    reach.limits.phi = {-3, 3};
    EXPECT_EQ(feasible_turns(reach, centres, 0).size(), 1U);
}

TEST(FeasibleTurns, FramesAreRightHandedAndFiveDegreesApart)
{
    const Vec3 axis = Vec3{1, 2, 3}.normalized();
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB}) {
        const RotaryReach reach{.configuration = configuration_of_family(family)};
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
