// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/figures/setup_figures.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "posed_setups.h"
#include "test_meshes.h"

namespace endmill {
namespace {

using test::range_deg;
using test::setup_turned;

const RotaryLimits needed{range_deg(-30, 60), range_deg(-20, 45)};

class SetupOfBothFamilies : public testing::TestWithParam<RotaryFamily> {};

TEST_P(SetupOfBothFamilies, HasTheMachinesAxes)
{
    const RotaryFrame frame =
        machine_directions(setup_turned(GetParam(), test::some_turn(), needed));
    const RotaryFrame machine = test::axes_of_machine(GetParam());
    EXPECT_LT((frame.tool_axis - machine.tool_axis).norm(), 1e-14);
    EXPECT_LT((frame.r1_axis - machine.r1_axis).norm(), 1e-14);
    EXPECT_LT((frame.r2_axis - machine.r2_axis).norm(), 1e-14);
}

// For a direction of the border one of the two rotary solutions has an angle at a limit.
TEST_P(SetupOfBothFamilies, HasBordersAtTheLimits)
{
    ShownSetup setup = setup_turned(GetParam(), test::some_turn(), needed);
    setup.limits = RotaryLimits{range_deg(-50, 80), range_deg(-60, 70)};
    bool has_machine = false;
    for (const SetupLine& line : motion_borders(setup, 0.05)) {
        const bool is_machine = line.object == SetupObject::MachineMotion;
        EXPECT_TRUE(is_machine || line.object == SetupObject::NeededMotion);
        has_machine |= is_machine;
        const RotaryLimits& limits = is_machine ? *setup.limits : needed;
        for (const Vec3& direction : line.directions) {
            const RotaryFrame machine = test::axes_of_machine(GetParam());
            // The pole, a corner of both sectors, has no unique angle.
            if (distance_from_singular(machine, direction) < 1e-12)
                continue;
            const RotaryAngles one = rotary_angles(machine, direction);
            const RotaryAngles other = other_rotary_angles(GetParam(), one);
            double off = 10;
            for (const RotaryAngles& a : {one, other})
                off = std::min({off, std::abs(a.phi - limits.phi.from),
                                std::abs(a.phi - limits.phi.to),
                                std::abs(a.theta - limits.theta.from),
                                std::abs(a.theta - limits.theta.to)});
            EXPECT_LT(off, 1e-12);
        }
    }
    EXPECT_TRUE(has_machine);
}

INSTANTIATE_TEST_SUITE_P(CAndAAndAAndB, SetupOfBothFamilies,
                         testing::Values(RotaryFamily::CA, RotaryFamily::AB));

TEST(ShownSetup, HasTheMachinesBorderOnlyWithLimits)
{
    for (const SetupLine& line :
         motion_borders(setup_turned(RotaryFamily::AB, test::some_turn(), needed), 0.1))
        EXPECT_EQ(line.object, SetupObject::NeededMotion);
}

TEST(ShownSetup, StandsPointsByTheAxes)
{
    const TriangleMesh box = test::box_mesh({-1, 2, 3}, {4, 5, 7});
    const ShownSetup setup = setup_turned(RotaryFamily::AB, test::some_turn(), needed);
    const std::vector<Vec3> points = posed_points(box, setup);
    ASSERT_EQ(points.size(), box.points().size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_NEAR(points[k].x(), setup.frame.r1_axis.dot(box.points()[k]), 1e-13);
        EXPECT_NEAR(points[k].y(), setup.frame.r2_axis.dot(box.points()[k]), 1e-13);
        EXPECT_NEAR(points[k].z(), setup.frame.tool_axis.dot(box.points()[k]), 1e-13);
    }
}

TEST(ShownSetup, SphereHoldsTheCornersOfABox)
{
    const PartSphere sphere =
        sphere_around(test::points_of(test::box_mesh({0, 0, 0}, {4, 4, 7})));
    EXPECT_EQ(sphere.centre, Vec3(2, 2, 3.5));
    EXPECT_NEAR(sphere.radius, 1.1 * 4.5, 1e-14);
}

TEST(ShownSetup, SphereAroundOnePlaceHasARadius)
{
    const PartSphere sphere = sphere_around({{1, 2, 3}, {1, 2, 3}});
    EXPECT_EQ(sphere.radius, 1);
    EXPECT_THROW(sphere_around({}), DomainError);
}

TEST(ShownSetup, NamesAxesByTheMachines)
{
    const RotaryFrame ca = test::axes_of_machine(RotaryFamily::CA);
    EXPECT_EQ(axis_label(SetupObject::ToolAxis, ca), "tool axis");
    EXPECT_EQ(axis_label(SetupObject::FirstAxis, ca), "R1 = C");
    EXPECT_EQ(axis_label(SetupObject::SecondAxis, ca), "R2 = A");
    const RotaryFrame ba{RotaryFamily::AB, Vec3::UnitZ(), Vec3::UnitY(), Vec3::UnitX()};
    EXPECT_EQ(axis_label(SetupObject::FirstAxis, ba), "R1 = B");
}

// Facet 0 is accessible along the cell nearest to the tool axis only, facet 1 along all
// others.
TEST(ReachedAtZero, UsesTheCellNearestToTheToolAxis)
{
    const SphereGrid grid = sphere_grid("hex:3");
    const std::size_t cell = 17;
    VisibilityMap map{2, grid.centres.size()};
    for (std::size_t k = 0; k < grid.centres.size(); ++k)
        map.column(k)[0] = k == cell ? 0b01 : 0b10;
    const Vec3 near = (grid.centres[cell] + Vec3{0.01, -0.01, 0.005}).normalized();
    EXPECT_EQ(reached_at_zero(grid, map, near), (std::vector<std::uint8_t>{1, 0}));
    EXPECT_EQ(reached_at_zero(grid, map, -near), (std::vector<std::uint8_t>{0, 1}));
}

TEST(ShownSetup, RefusesAMirror)
{
    ShownSetup setup = setup_turned(RotaryFamily::CA, test::some_turn(), needed);
    setup.part_to_machine.row(0) *= -1;
    EXPECT_THROW(machine_directions(setup), DomainError);
    setup.part_to_machine = 2 * test::some_turn();
    EXPECT_THROW(machine_directions(setup), DomainError);
}

}  // namespace
}  // namespace endmill
