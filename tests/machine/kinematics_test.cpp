// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/kinematics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/machine/configuration.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

Machine machine_of(const std::string& word)
{
    Machine machine{.configuration = configuration_from_word(word)};
    machine.rotary = widest_limits(machine.configuration);
    return machine;
}

std::vector<Machine> valid_machines()
{
    std::vector<Machine> valid;
    for (const std::string& word : rotary_words()) {
        valid.push_back(machine_of(whole_word(word)));
        valid.back().pivot = 150;
        valid.back().table_offset = {3, -4, -70};
        if (!valid.back().configuration.is_valid())
            valid.pop_back();
    }
    return valid;
}

// Positions of three machines. Source: docs/methods/five-axis-setup.md, section 9
// (9.2).
struct PrintedPosition {
    const char* word;
    RotaryPositions degrees;
    Vec3 table_offset;
    Vec3 direction;
    Vec3 xyz;
};

TEST(Kinematics, GiveThePositionsOfTheTable)
{
    const Vec3 point{50, 20, 30};
    const Vec3 same{0.2716538, -0.3237444, 0.9063078};
    for (const PrintedPosition& row :
         {PrintedPosition{"W/cBaxyz/T",
                          {-40, 25},
                          {0, 0, 0},
                          same,
                          {51.1579743, -101.3421440, 11.2615574}},
          PrintedPosition{"W/Bcaxyz/T",
                          {40, 25},
                          {0, 0, 0},
                          same,
                          {104.3307565, -44.7488742, 11.2615574}},
          PrintedPosition{"W/baBxyz/T",
                          {30, -20},
                          {0, 0, -50},
                          {-0.4698463, -0.3420201, 0.8137977},
                          {83.3012702, 33.9391995, -15.2289039}}}) {
        Machine machine = machine_of(row.word);
        machine.table_offset = row.table_offset;
        const AxisPositions at = axis_positions(
            machine, {rad(row.degrees[0]), rad(row.degrees[1])}, point, 200);
        EXPECT_LT((at.xyz - row.xyz).norm(), 1e-7) << row.word;
        EXPECT_LT((tool_location(machine, at, 200).axis - row.direction).norm(), 1e-7)
            << row.word;
    }
}

// The joints of a machine as a chain from part to bed and from bed to tool. A point and a
// direction are moved along the chain axis by axis.
struct Carried {
    Vec3 point;
    Vec3 axis;
};

Carried carried_by_hand(const Machine& machine, const RotaryPositions& rotary, Vec3 point,
                        double length)
{
    const auto turn = [](char letter, double angle, const Vec3& v) -> Vec3 {
        const double c = std::cos(angle);
        const double s = std::sin(angle);
        if (letter == 'a')
            return {v.x(), c * v.y() - s * v.z(), s * v.y() + c * v.z()};
        if (letter == 'b')
            return {c * v.x() + s * v.z(), v.y(), -s * v.x() + c * v.z()};
        return {c * v.x() - s * v.y(), s * v.x() + c * v.y(), v.z()};
    };
    const auto& axes = machine.configuration.rotary;
    point -= machine.table_offset;
    for (std::size_t k = 0; k < axes.size();
         ++k)  // the axis nearest to the part acts first
        if (axes[k].side == MachineSide::Table)
            point = turn(axes[k].letter, rotary[k], point);
    Vec3 axis = Vec3::UnitZ();
    for (std::size_t k = axes.size();
         k-- > 0;)  // the axis nearest to the tool acts first
        if (axes[k].side == MachineSide::Head)
            axis = turn(axes[k].letter, rotary[k], axis);
    const Vec3 shift = (machine.pivot + length) * (axis - Vec3::UnitZ());
    for (std::size_t k = axes.size();
         k-- > 0;)  // back to the part: inverse turns, from the bed
        if (axes[k].side == MachineSide::Table)
            axis = turn(axes[k].letter, -rotary[k], axis);
    return {point + machine.table_offset + shift, axis};
}

TEST(Kinematics, AreThoseOfTheChainOfJoints)
{
    test::Random random{1};
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 200; ++k) {
            const RotaryPositions rotary{random.uniform(-pi, pi),
                                         random.uniform(-pi, pi)};
            const Vec3 point{random.uniform(-99, 99), random.uniform(-99, 99),
                             random.uniform(-99, 99)};
            const AxisPositions at = axis_positions(machine, rotary, point, 80);
            const Carried expected = carried_by_hand(machine, rotary, point, 80);
            EXPECT_LT((at.xyz - expected.point).norm(), 1e-12)
                << machine.configuration.word;
            const CutterLocation seen = tool_location(machine, at, 80);
            EXPECT_LT((seen.tip - point).norm(), 1e-12) << machine.configuration.word;
            EXPECT_LT((seen.axis - expected.axis).norm(), 1e-14)
                << machine.configuration.word;
        }
}

TEST(Kinematics, AtZeroGiveTheCoordinatesOfThePoint)
{
    for (const Machine& machine : valid_machines())
        EXPECT_LT(
            (axis_positions(machine, {0, 0}, {1, 2, 3}, 9).xyz - Vec3(1, 2, 3)).norm(),
            1e-14);
}

// Forward kinematics after inverse kinematics gives the direction, for both solutions.
TEST(RotarySolutions, GiveTheDirection)
{
    test::Random random{2};
    for (const Machine& machine : valid_machines())
        for (int k = 0; k < 500; ++k) {
            const Vec3 direction{random.uniform(-1, 1), random.uniform(-1, 1),
                                 random.uniform(-1, 1)};
            const auto solutions = rotary_solutions(machine, direction);
            ASSERT_EQ(solutions.size(), 2U);
            EXPECT_NE(solutions[0].positions, solutions[1].positions);
            for (const RotarySolution& solution : solutions) {
                const AxisPositions at =
                    axis_positions(machine, solution.positions, {5, 6, 7}, 100);
                const CutterLocation seen = tool_location(machine, at, 100);
                EXPECT_LT((seen.axis - direction.normalized()).norm(), 1e-14);
                EXPECT_TRUE(solution.is_within_limits);
                EXPECT_TRUE(is_within_travel(machine, at));
            }
        }
}

TEST(RotarySolutions, AreMovedIntoTheLimitsByWholeTurns)
{
    Machine machine = machine_of("W/Bcaxyz/T");
    machine.rotary = {.phi = {0, rad(100)}, .theta = {rad(-300), 0}};
    const auto solutions = rotary_solutions(
        machine, turned_tool_axis(machine_frame(machine.configuration), {1, 2}));
    EXPECT_NEAR(solutions[0].positions[0], 2 - 2 * pi, 1e-14);
    EXPECT_NEAR(solutions[0].positions[1], 1, 1e-14);
    EXPECT_TRUE(solutions[0].is_within_limits);
    EXPECT_FALSE(solutions[1].is_within_limits);  // the tilt would be negative
}

TEST(RotarySolutions, AtThePoleHaveNoNeedlessTurn)
{
    for (const Machine& machine : valid_machines()) {
        const auto solutions = rotary_solutions(machine, {0, 0, 2});
        EXPECT_NEAR(solutions[0].positions[0], 0, 1e-15) << machine.configuration.word;
        EXPECT_NEAR(solutions[0].positions[1], 0, 1e-15);
    }
    const auto along_r1 = rotary_solutions(machine_of("W/Babxyz/T"), {1, 1e-12, 0});
    EXPECT_EQ(along_r1[0].positions[0], 0);
    EXPECT_NEAR(along_r1[0].positions[1], pi / 2, 1e-11);
}

TEST(RotarySolutions, OfFewerAxesAreOneOrNone)
{
    const Machine four = machine_of("W/axyBz/T");
    const auto found = rotary_solutions(four, {0, -std::sin(0.4), std::cos(0.4)});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].positions[0], -0.4, 1e-15);  // the sign changes in a table
    EXPECT_TRUE(rotary_solutions(four, {0.1, 0, 1}).empty());
    const Machine three = machine_of("W/xyBz/T");
    EXPECT_EQ(rotary_solutions(three, {0, 0, 1}).size(), 1U);
    EXPECT_TRUE(rotary_solutions(three, {0, 0.1, 1}).empty());
    EXPECT_TRUE(rotary_solutions(three, {0, 0, -1}).empty());
}

TEST(RotarySolutions, NeedADirectionAndAMachine)
{
    const Machine machine = machine_of("W/caxyBz/T");
    EXPECT_THROW(rotary_solutions(machine, {0, 0, 0}), DomainError);
    EXPECT_THROW(rotary_solutions(machine, {0, std::nan(""), 1}), DomainError);
    EXPECT_THROW(rotary_solutions({configuration_from_word("W/acxyBz/T")}, {0, 0, 1}),
                 DomainError);
    EXPECT_EQ(rotary_solutions(machine, {0, 1e-300, 1e-300}).size(), 2U);
}

TEST(Travel, LimitsEveryAxis)
{
    Machine machine = machine_of("W/cxyBza/T");
    machine.rotary.phi = {rad(-20), rad(100)};
    machine.linear[2] = {-300, 0};
    EXPECT_TRUE(is_within_travel(machine, {{rad(720), rad(100)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, rad(101)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, rad(360)}, {0, 0, -300}}));
    EXPECT_FALSE(is_within_travel(machine, {{0, 0}, {0, 0, 1}}));
    machine.rotary.theta = {rad(-10), rad(30)};  // turns of a table: positions -30 to 10
    EXPECT_TRUE(is_within_travel(machine, {{rad(-30), 0}, {0, 0, 0}}));
    EXPECT_FALSE(is_within_travel(machine, {{rad(30), 0}, {0, 0, 0}}));
}

}  // namespace
}  // namespace endmill
