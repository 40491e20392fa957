// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/path_setup.h"

#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/core/parallel.h"

namespace endmill {
namespace {

using testing::HasSubstr;

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

// Unit vector with a polar angle from +z and an azimuth, degrees.
Vec3 direction(double polar, double azimuth)
{
    return {std::sin(rad(polar)) * std::cos(rad(azimuth)),
            std::sin(rad(polar)) * std::sin(rad(azimuth)), std::cos(rad(polar))};
}

// A path that cuts from each axis and turns in the air, 200 mm away, by steps of 5 degrees.
ToolPath path_of(const std::vector<Vec3>& axes)
{
    ToolPath path;
    const auto add = [&](Move move, const Vec3& tip, const Vec3& axis) {
        path.points.push_back({.pass = 0,
                               .point = static_cast<int>(path.points.size()),
                               .move = move,
                               .location = {tip, axis}});
    };
    for (std::size_t k = 0; k < axes.size(); ++k) {
        for (int step = 1; k > 0 && step <= 36; ++step) {
            const Vec3 axis = axis_on_arc(axes[k - 1], axes[k], step / 36.0).normalized();
            add(Move::Rapid, 200 * axis, step == 36 ? axes[k] : axis);
        }
        add(Move::Plunge, 20 * axes[k], axes[k]);
        add(Move::Cut, 20 * axes[k] + 10 * axes[k].unitOrthogonal(), axes[k]);
        add(Move::Rapid, 200 * axes[k], axes[k]);
    }
    return path;
}

// A tilting rotary table, C on A, as datasets/machines/ca-table-table.json.
Machine tilting_table()
{
    Machine machine{.configuration = configuration_from_word("W/caxyBz/T"),
                    .table_offset = {0, 0, -60}};
    machine.rotary = widest_limits(machine.configuration);
    machine.rotary.phi = {rad(-30), rad(120)};  // turns: A from -120 to 30
    machine.wide_positions[0] = RotaryRange{rad(-360), rad(360)};
    return machine;
}

Machine fork_head()
{
    Machine machine{.configuration = configuration_from_word("W/xyBzcb/T"), .pivot = 250};
    machine.rotary = widest_limits(machine.configuration);
    machine.rotary.phi = {rad(-110), rad(110)};
    machine.wide_positions[0] = RotaryRange{rad(-360), rad(360)};
    return machine;
}

Machine table_and_head()
{
    Machine machine{.configuration = configuration_from_word("W/axyBzb/T"), .pivot = 180};
    machine.rotary = widest_limits(machine.configuration);
    machine.rotary.phi = {rad(-90), rad(90)};
    machine.rotary.theta = {rad(-45), rad(45)};
    return machine;
}

// Forward kinematics, another route than the search: each position of the machine is within
// its limits, gives the pose of the motions, and every pose of the path is among them.
void expect_run(const ToolPath& path, const Machine& machine, const PathSetup& found)
{
    EXPECT_NEAR((found.part_to_machine * found.part_to_machine.transpose() -
                 Eigen::Matrix3d::Identity())
                    .norm(),
                0, 1e-12);
    EXPECT_NEAR(found.part_to_machine.determinant(), 1, 1e-12);
    const PartOnMachine setup{machine, 0, found.part_to_machine, found.clamping.clamp};
    const auto& positions = found.motions.path.machine->positions;
    ASSERT_EQ(positions.size(), found.motions.path.points.size());
    std::size_t row = 0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        EXPECT_TRUE(is_within_travel(machine, positions[i]));
        const CutterLocation at = tool_location(setup, positions[i]);
        const CutterLocation& stated = found.motions.path.points[i].location;
        EXPECT_NEAR((at.tip - stated.tip).norm() + (at.axis - stated.axis).norm(), 0,
                    1e-9);
        while (row < path.points.size() &&
               (path.points[row].location.tip - at.tip).norm() +
                       (path.points[row].location.axis - at.axis).norm() <
                   1e-9)
            ++row;
    }
    EXPECT_EQ(row, path.points.size());
}

TEST(PathSetup, KeepsThePartAsItStandsWhereThatSuffices)
{
    const ToolPath path =
        path_of({direction(0, 0), direction(40, 10), direction(70, 200)});
    const PathSetup found = path_setup(path, tilting_table());
    EXPECT_EQ(found.poses_tried, 1U);
    EXPECT_NEAR((found.part_to_machine - Eigen::Matrix3d::Identity()).norm(), 0, 1e-15);
    expect_run(path, tilting_table(), found);
}

// The axes lie around -z, up to 150 degrees from +z and more: as it stands no table that tilts
// by 120 degrees reaches them, after a rotation every one does.
TEST(PathSetup, TurnsThePartSoThatAllAxesAreWithinReach)
{
    const ToolPath path =
        path_of({direction(180, 0), direction(130, 20), direction(150, 140),
                 direction(120, 260), direction(100, 30)});
    for (const Machine& machine : {tilting_table(), fork_head(), table_and_head()}) {
        const PathSetup found = path_setup(path, machine);
        EXPECT_GT(found.poses_tried, 1U);
        EXPECT_EQ(found.axes, 5U + 4 * 35);
        expect_run(path, machine, found);
    }
}

// Two axes an angle apart, and those of the arc between, fit where the half angle of the
// reach is at least half of it: tilts of 0 to 20 degrees on both sides of C allow 40.
TEST(PathSetup, FindsASetupUpToTheReachOfTheMachine)
{
    Machine machine = fork_head();
    machine.rotary.phi = {rad(-20), rad(20)};
    const ToolPath within = path_of({direction(90, 0), direction(90, 39.99)});
    expect_run(within, machine, path_setup(within, machine));
    const ToolPath beyond = path_of({direction(90, 0), direction(90, 50)});
    try {
        path_setup(beyond, machine);
        FAIL();
    } catch (const GeometryError& error) {
        // step k of 36 to 50 degrees is the first beyond 40 at k = 29: row 2 + 29
        EXPECT_THAT(error.what(),
                    HasSubstr("point 31 of the path: no rotation of the part brings its "
                              "tool axis"));
    }
}

// The best clamping position for one axis: the middle of the travel that the path leaves.
TEST(PathSetup, ClampsThePartInTheMiddleOfItsTravel)
{
    Machine machine = tilting_table();
    machine.linear = {LinearRange{-300, 500}, LinearRange{-250, 250},
                      LinearRange{-100, 900}};
    const ToolPath path = path_of({direction(0, 0)});  // z from 20 to 200, x from 0 to 10
    const PathSetup found = path_setup(path, machine);
    const double length =
        path.points[1].location.tip.head<2>().norm();  // 10 along x or y
    EXPECT_NEAR(length, 10, 1e-12);
    EXPECT_NEAR(found.clamping.clamp.z() + 110, 400, 1e-6);
    EXPECT_NEAR(found.clamping.slack.z(), 410, 1e-6);
    expect_run(path, machine, found);
}

TEST(PathSetup, ReportsTravelThatIsTooShortWithThePoint)
{
    Machine machine = tilting_table();
    machine.linear[2] = {-50, 50};
    const ToolPath path = path_of({direction(0, 0)});  // needs 180 mm
    try {
        path_setup(path, machine);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr(" of the path: Z exceeds its travel by 40 mm"));
        EXPECT_THAT(error.what(), HasSubstr("501 rotations of the part were tried"));
    }
}

TEST(PathSetup, RefusesMachinesWithoutTwoRotaryAxesAndEmptyPaths)
{
    Machine machine;
    machine.configuration = configuration_from_word("W/axyBz/T");
    EXPECT_THROW(path_setup(path_of({direction(0, 0)}), machine), DomainError);
    EXPECT_THROW(path_setup({}, tilting_table()), DomainError);
}

TEST(PathSetup, IsTheSameForAnyNumberOfThreads)
{
    const ToolPath path = path_of({direction(180, 0), direction(130, 20)});
    std::vector<PathSetup> found;
    for (const int threads : {1, 2, 3, 8}) {
        set_thread_count(threads);
        found.push_back(path_setup(path, tilting_table()));
    }
    for (const PathSetup& other : found) {
        EXPECT_EQ(other.part_to_machine, found.front().part_to_machine);
        EXPECT_EQ(other.clamping.clamp, found.front().clamping.clamp);
        EXPECT_EQ(other.poses_tried, found.front().poses_tried);
    }
}

}  // namespace
}  // namespace endmill
