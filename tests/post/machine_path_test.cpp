// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/post/machine_path.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "five_axis.h"

namespace endmill {
namespace {

using test::cone_path;
using test::direction;
using test::part_on;
using test::path_through;
using test::rad;
using testing::HasSubstr;

double degrees(double radians)
{
    return Angle::radians(radians).degrees();
}

// Poses at one tip with the given tilts and turns.
ToolPath poses_at(const PartOnMachine& setup, const Vec3& tip,
                  const std::vector<std::array<double, 2>>& turns)
{
    std::vector<CutterLocation> poses;
    for (const auto& [phi, theta] : turns)
        poses.push_back({tip, direction(setup, phi, theta)});
    return path_through(poses);
}

// The largest distance of the machine's tip, and of the axis, from the linear path, for
// moves that were divided evenly in their parameter, by sampling.
struct Deviation {
    double tip = 0;
    double axis = 0;
};

Deviation sampled_deviation(const MachinePath& made, const ToolPath& path)
{
    Deviation worst;
    const auto& points = made.path.points;
    const auto& positions = made.path.machine->positions;
    for (std::size_t i = 1; i < points.size(); ++i) {
        const CutterLocation& start = path.points[made.rows[i] - 1].location;
        const CutterLocation& end = path.points[made.rows[i]].location;
        const double way = (end.tip - start.tip).norm();
        for (int k = 0; k <= 10; ++k) {
            const CutterLocation at =
                tool_location(made.path.machine->setup,
                              test::between(positions[i - 1], positions[i], k / 10.0));
            const double u_from =
                way > 0 ? (points[i - 1].location.tip - start.tip).norm() / way : 0;
            const double u_to =
                way > 0 ? (points[i].location.tip - start.tip).norm() / way : 1;
            const double u = u_from + (u_to - u_from) * k / 10.0;
            worst.tip =
                std::max(worst.tip, (at.tip - (1 - u) * start.tip - u * end.tip).norm());
            worst.axis = std::max(
                worst.axis, angle_between(at.axis, axis_on_arc(start.axis, end.axis, u)));
        }
    }
    return worst;
}

// Check [11]: straight through the pole, C stands still.
TEST(MachinePath, GoesThroughThePoleWithoutATurn)
{
    for (const char* word : {"caB", "cBa", "Bca", "cbB", "cBb", "Bcb"}) {
        const PartOnMachine setup = part_on(word);
        const MachinePath made = machine_path(
            poses_at(setup, {10, 0, 0}, {{20, 30}, {0, 0}, {-20, 30}}), setup);
        EXPECT_NEAR(degrees(made.report.rotary_travel), 40, 1e-9) << word;
        for (const AxisPositions& at : made.path.machine->positions)
            EXPECT_NEAR(at.rotary[0], made.path.machine->positions[0].rotary[0], 1e-12);
    }
}

// The same without a point in the pole: it lies on the arc between the points.
TEST(MachinePath, FindsThePoleBetweenPoints)
{
    const PartOnMachine setup = part_on("caB");
    const MachinePath made =
        machine_path(poses_at(setup, {10, 0, 0}, {{25, 30}, {-15, 30}}), setup);
    EXPECT_NEAR(degrees(made.report.rotary_travel), 40, 1e-9);
}

// Check [12]: a corner in the pole. The first axis turns while the tool stands still.
TEST(MachinePath, TurnsInThePoleWithTheToolAtRest)
{
    const PartOnMachine setup = part_on("caB");
    const Vec3 tip{30, 5, 2};
    const MachinePath right =
        machine_path(poses_at(setup, tip, {{20, 0}, {0, 0}, {20, 90}}), setup);
    EXPECT_NEAR(degrees(right.report.rotary_travel), 130, 1e-9);
    const MachinePath wide =
        machine_path(poses_at(setup, tip, {{20, 0}, {0, 0}, {20, 120}}), setup);
    EXPECT_NEAR(degrees(wide.report.rotary_travel), 100, 1e-9);
    for (const MachinePath& made : {right, wide})
        for (std::size_t i = 0; i < made.path.points.size(); ++i) {
            const CutterLocation at =
                tool_location(made.path.machine->setup, made.path.machine->positions[i]);
            EXPECT_LT((at.tip - tip).norm(), 1e-9);
            if (made.path.points[i].move == Move::Link) {
                EXPECT_LT((at.axis - Vec3::UnitZ()).norm(), 1e-9);
            }
        }
}

// Check [13]: past the pole C turns by 2 acos(tan e / tan phi).
TEST(MachinePath, TurnsFarPastThePole)
{
    const PartOnMachine setup = part_on("caB");
    for (const auto& [off, expected] :
         {std::array{0.5, 174.326256}, std::array{0.05, 179.432869}}) {
        // The great arc has its closest point to the pole at the angle `off`.
        const double turn = degrees(std::acos(std::tan(rad(off)) / std::tan(rad(10))));
        const MachinePath made =
            machine_path(poses_at(setup, {5, 0, 0}, {{10, -turn}, {10, turn}}), setup);
        const auto& positions = made.path.machine->positions;
        EXPECT_NEAR(
            degrees(std::abs(positions.back().rotary[0] - positions.front().rotary[0])),
            expected, 1e-6);
    }
}

// With the rule Turn the same path takes the pole, so that C need not turn.
TEST(MachinePath, MayTakeThePoleInTheCone)
{
    const PartOnMachine setup = part_on("caB");
    const double turn = degrees(std::acos(std::tan(rad(0.05)) / std::tan(rad(10))));
    const ToolPath path = poses_at(setup, {5, 0, 0}, {{10, -turn}, {10, turn}});
    const MachinePath made = machine_path(path, setup, {.singular = SingularRule::Turn});
    EXPECT_EQ(made.report.singular_points, 1U);
    EXPECT_LT(degrees(made.report.rotary_travel), 20 + 180 - 2 * turn + 1);
    EXPECT_EQ(made.report.branch_changes, 1U);
}

// Check [14]: one piece is off by 0.190265095 mm and 0.094498594 degrees.
TEST(MachinePath, DividesAMoveByTheToleranceOfTheTip)
{
    PartOnMachine setup = part_on("caB");
    setup.tool_length = 100;
    const ToolPath path = poses_at(setup, {50, 0, 0}, {{30, 20}, {30, 30}});
    MachinePathOptions options{.tolerance = 1, .cutter = Cutter::ball(0.1)};
    const MachinePath whole = machine_path(path, setup, options);
    EXPECT_EQ(whole.report.pieces, 1U);
    const auto& ends = whole.path.machine->positions;
    double tip = 0;
    double axis = 0;
    for (int k = 0; k <= 1000; ++k) {
        const double u = k / 1000.0;
        const CutterLocation at =
            tool_location(setup, test::between(ends[0], ends[1], u));
        tip = std::max(tip, (at.tip - Vec3{50, 0, 0}).norm());
        axis = std::max(
            axis, angle_between(at.axis, axis_on_arc(path.points[0].location.axis,
                                                     path.points[1].location.axis, u)));
    }
    EXPECT_NEAR(tip, 0.190265095, 1e-6);
    EXPECT_NEAR(degrees(axis), 0.094498594, 1e-6);
    EXPECT_GE(whole.report.max_tip_error_mm, tip);
    // Seven even pieces keep 0.005 mm, six do not; halving makes eight.
    const auto worst_of_pieces = [&](int count) {
        double worst = 0;
        for (int piece = 0; piece < count; ++piece) {
            // The tip stands still in the part at the ends of each piece.
            const auto at_end = [&](double share) {
                AxisPositions at = test::between(ends[0], ends[1], share);
                at.xyz = axis_positions(setup, at.rotary, {50, 0, 0}).xyz;
                return at;
            };
            const AxisPositions from = at_end(piece / static_cast<double>(count));
            const AxisPositions to = at_end((piece + 1) / static_cast<double>(count));
            for (int i = 0; i <= 100; ++i)
                worst = std::max(
                    worst, (tool_location(setup, test::between(from, to, i / 100.0)).tip -
                            Vec3{50, 0, 0})
                               .norm());
        }
        return worst;
    };
    EXPECT_LE(worst_of_pieces(7), 0.005);
    EXPECT_GT(worst_of_pieces(6), 0.005);
    options.tolerance = 0.005;
    EXPECT_EQ(machine_path(path, setup, options).report.pieces, 8U);
}

// The machine stays within the tolerance, by sampling, for all machines.
TEST(MachinePath, StaysWithinTheTolerance)
{
    test::Random random{31};
    for (int k = 0; k < 60; ++k) {
        const PartOnMachine setup = test::random_part_on_machine(random, true);
        const Vec3 lean = test::random_vector(random, 0.4);
        std::vector<CutterLocation> poses;
        for (int i = 0; i < 5; ++i)
            poses.push_back(
                {test::random_vector(random, 20),
                 (direction(setup, 30, 40) + lean + test::random_vector(random, 0.3))
                     .normalized()});
        const ToolPath path = path_through(poses);
        const MachinePathOptions options{.tolerance = 0.01, .cutter = Cutter{4, 1}};
        const MachinePath made = machine_path(path, setup, options);
        const Deviation worst = sampled_deviation(made, path);
        EXPECT_LE(worst.tip, made.report.max_tip_error_mm + 1e-9);
        EXPECT_LE(worst.axis, made.report.max_axis_error + 1e-9);
        EXPECT_LE(made.report.max_tip_error_mm, 0.01);
        EXPECT_LE(4 * made.report.max_axis_error, 0.01);
    }
}

// A control with its own kinematics needs points for the axis alone.
TEST(MachinePath, InThePartNeedsFewerPieces)
{
    PartOnMachine setup = part_on("caB");
    setup.tool_length = 100;
    const ToolPath path = cone_path(40, 30, 36);
    const MachinePath joint = machine_path(path, setup);
    const MachinePath part = machine_path(path, setup, {.frame = Interpolation::Tcp});
    EXPECT_LT(part.report.pieces, joint.report.pieces);
    EXPECT_EQ(part.path.interpolation(), Interpolation::Tcp);
    EXPECT_NEAR(degrees(part.report.rotary_travel), 360, 1e-6);
}

// A constant axis needs no further points.
TEST(MachinePath, OfAConstantAxisKeepsItsPoints)
{
    const PartOnMachine setup = part_on("Bcb");
    const MachinePath made =
        machine_path(path_through({{{0, 0, 0}, direction(setup, 20, 10)},
                                   {{10, 0, 0}, direction(setup, 20, 10)},
                                   {{10, 30, 0}, direction(setup, 20, 10)}}),
                     setup);
    EXPECT_EQ(made.path.points.size(), 3U);
    EXPECT_EQ(made.report.max_tip_error_mm, 0);
    EXPECT_NEAR(made.minutes[1], 10.0 / 600, 1e-15);
    EXPECT_NEAR(made.report.time_min, 40.0 / 600, 1e-15);
}

// Check [6]: a rate makes a move longer. C by 90 degrees at 3600 degrees/min takes 1/40 min.
TEST(MachinePath, KeepsTheRatesOfTheAxes)
{
    PartOnMachine setup = part_on("caB");
    setup.machine.rates.rotary_rad_per_min[0] = rad(3600);
    const MachinePath made =
        machine_path(poses_at(setup, {0, 0, 0}, {{30, 0}, {30, 45}, {30, 90}}), setup);
    // C turns by the whole angle, though not evenly, so the pieces take at least as long.
    EXPECT_GE(made.report.time_min, 1.0 / 40 - 1e-12);
    EXPECT_NEAR(made.report.time_min, 1.0 / 40, 1e-4);
    for (std::size_t i = 1; i < made.minutes.size(); ++i) {
        const double turn = made.path.machine->positions[i].rotary[0] -
                            made.path.machine->positions[i - 1].rotary[0];
        EXPECT_GE(made.minutes[i] * rad(3600), std::abs(turn) - 1e-12);
    }
}

// Check [10]: without a way the message names the point, the axis and the limit; with a
// retract the tool leaves the part once and every motion in the air stays outside.
TEST(MachinePath, RetractsWhereNoPositionLeadsOn)
{
    PartOnMachine setup = part_on("Bca");
    setup.machine.wide_positions[0] = RotaryRange{rad(-200), rad(200)};
    setup.machine.rotary.phi = {0, rad(120)};
    std::vector<std::array<double, 2>> turns;
    for (int azimuth = 0; azimuth <= 300; azimuth += 10)
        turns.push_back({30, azimuth * 1.0});
    const ToolPath path = poses_at(setup, {10, 0, 0}, turns);
    try {
        machine_path(path, setup);
        FAIL();
    } catch (const GeometryError& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("point 21 of the path: axis C at 210 degrees exceeds its "
                              "limit 200 by 10; expected another setup (endmill setup "
                              "--path), wider limits or --retract"));
    }
    const MachinePath made = machine_path(path, setup, {.retract = 50});
    EXPECT_EQ(made.report.retracts, 1U);
    EXPECT_NEAR(degrees(made.report.rotary_travel), 660, 1e-6);
    for (std::size_t i = 1; i < made.path.points.size(); ++i) {
        const auto& positions = made.path.machine->positions;
        const double turn = std::abs(positions[i].rotary[0] - positions[i - 1].rotary[0]);
        if (made.path.points[i].move == Move::Rapid && turn > 1e-9)
            for (int k = 0; k <= 10; ++k) {
                const Vec3 tip =
                    tool_location(setup,
                                  test::between(positions[i - 1], positions[i], k / 10.0))
                        .tip;
                EXPECT_GT((tip - Vec3{10, 0, 0}).norm(), 50 - 0.1);
            }
    }
}

TEST(MachinePath, RefusesWhatTheMachineCannotReach)
{
    const auto complaint = [](const ToolPath& path, const PartOnMachine& setup) {
        try {
            machine_path(path, setup);
        } catch (const Error& error) {
            return error.code() + ' ' + error.what();
        }
        return std::string{};
    };
    PartOnMachine setup = part_on("caB");
    setup.machine.rotary.phi = {rad(-30), rad(40)};
    EXPECT_THAT(complaint(poses_at(setup, {0, 0, 0}, {{10, 0}, {50, 0}}), setup),
                HasSubstr("E_GEOMETRY point 1 of the path: axis A at -50 degrees exceeds "
                          "its limit -40 by 10"));
    EXPECT_THAT(complaint(path_through({{{0, 0, 0}, {0, 0, 1}}, {{0, 0, 0}, {0, 0, -1}}}),
                          part_on("caB")),
                HasSubstr("point 1 of the path: the axis turns by 180 degrees"));
    PartOnMachine spun;
    spun.machine.configuration = configuration_from_word("W/acxyBz/T");
    EXPECT_THAT(complaint(path_through({{{0, 0, 0}, {0, 0, 1}}}), spun),
                HasSubstr("E_GEOMETRY the machine W/acxyBz/T cannot direct its tool"));
    EXPECT_THAT(complaint({}, part_on("caB")), HasSubstr("E_PARAM"));
    EXPECT_THAT(complaint(path_through({{{0, 0, 0}, {0, 0, 2}}}), part_on("caB")),
                HasSubstr("point 0 of the path"));
    const PartOnMachine four = part_on("caB");
    PartOnMachine single;
    single.machine.configuration = configuration_from_word("W/axyBz/T");
    single.machine.rotary = widest_limits(single.machine.configuration);
    EXPECT_THAT(complaint(poses_at(four, {0, 0, 0}, {{20, 40}}), single),
                HasSubstr("leaves the plane"));
}

// A clamping position that fits is named, and fits.
TEST(MachinePath, NamesAClampingPositionWithinTheTravel)
{
    PartOnMachine setup = part_on("caB");
    setup.machine.linear[0] = {-100, 100};
    setup.machine.linear[1] = {-100, 100};
    setup.clamp = {180, 0, 0};
    const ToolPath path = cone_path(20, 20, 12);
    try {
        machine_path(path, setup);
        FAIL();
    } catch (const GeometryError& error) {
        const std::string message = error.what();
        EXPECT_THAT(message, HasSubstr("exceeds its travel -100 by"));
        const std::size_t at = message.find("--clamp ");
        ASSERT_NE(at, std::string::npos) << message;
        Vec3& clamp = setup.clamp;
        ASSERT_EQ(std::sscanf(message.c_str() + at, "--clamp %lf,%lf,%lf", &clamp.x(),
                              &clamp.y(), &clamp.z()),
                  3);
        EXPECT_NO_THROW(machine_path(path, setup));
    }
}

// A path that a machine interpolates gives the same motions again.
TEST(MachinePath, OfAMachinesPathStaysWithinTheTolerance)
{
    PartOnMachine setup = part_on("cBb");
    setup.tool_length = 120;
    const ToolPath path = cone_path(40, 25, 24);
    const MachinePath first = machine_path(path, setup);
    const PartOnMachine other = part_on("caB");
    const MachinePath second = machine_path(first.path, other, {.tolerance = 0.01});
    EXPECT_EQ(second.path.machine->setup.machine.configuration.word, "W/caBxyz/T");
    for (const PathPoint& point : second.path.points) {
        EXPECT_NEAR(point.location.tip.head<2>().norm(), 40,
                    0.02 + 40 * (1 - std::cos(rad(7.5))));
        EXPECT_NEAR(point.location.tip.z(), 10, 0.02);
    }
}

}  // namespace
}  // namespace endmill
