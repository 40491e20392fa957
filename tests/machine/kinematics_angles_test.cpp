// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/kinematics.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>
#include <Eigen/Geometry>

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

RotaryFrame frame_of(const std::string& rotary_word)
{
    return machine_frame(configuration_from_word(whole_word(rotary_word)));
}

std::vector<MachineConfiguration> valid_machines()
{
    std::vector<MachineConfiguration> valid;
    for (const std::string& word : rotary_words()) {
        valid.push_back(configuration_from_word(whole_word(word)));
        if (!valid.back().is_valid())
            valid.pop_back();
    }
    return valid;
}

// The direction by Eigen's rotations instead of the closed form.
Vec3 turned(const RotaryFrame& frame, const RotaryAngles& angles)
{
    const bool is_ca = frame.family == RotaryFamily::CA;
    const Eigen::AngleAxisd first{is_ca ? angles.theta : angles.phi, frame.r1_axis};
    const Eigen::AngleAxisd second{is_ca ? angles.phi : angles.theta, frame.r2_axis};
    return first * (second * frame.tool_axis);
}

// Source: docs/methods/five-axis-setup.md, section 9 (9.2).
TEST(RotaryAngles, GiveTheDirectionsOfTheTable)
{
    const double s = std::sin(rad(30));
    const double c = std::cos(rad(30));
    EXPECT_LT((turned_tool_axis(frame_of("caB"), {rad(30), 0}) - Vec3(0, -s, c)).norm(),
              1e-15);
    const RotaryAngles angles{rad(20), rad(30)};
    EXPECT_LT(
        (turned_tool_axis(frame_of("abB"), angles) - Vec3(0.5, -0.2961981, 0.8137977))
            .norm(),
        1e-7);
    EXPECT_LT(
        (turned_tool_axis(frame_of("baB"), angles) - Vec3(0.2961981, -0.5, 0.8137977))
            .norm(),
        1e-7);
}

TEST(RotaryAngles, TurnTheToolAxisAsItsAxesDo)
{
    test::Random random{1};
    for (const MachineConfiguration& machine : valid_machines())
        for (int k = 0; k < 1000; ++k) {
            const RotaryFrame frame = machine_frame(machine);
            const RotaryAngles angles{random.uniform(-pi, pi), random.uniform(-pi, pi)};
            EXPECT_LT((turned_tool_axis(frame, angles) - turned(frame, angles)).norm(),
                      1e-15)
                << machine.word;
        }
}

TEST(RotaryAngles, AreRecoveredFromTheDirection)
{
    test::Random random{2};
    for (const MachineConfiguration& machine : valid_machines())
        for (int k = 0; k < 1000; ++k) {
            const bool is_ca = machine.family == RotaryFamily::CA;
            const RotaryAngles given{
                is_ca ? random.uniform(rad(0.1), rad(179.9)) : random.uniform(-pi, pi),
                is_ca ? random.uniform(-pi, pi) : random.uniform(rad(-89.9), rad(89.9))};
            const RotaryFrame frame = machine_frame(machine);
            const Vec3 direction = turned(frame, given);
            const RotaryAngles found = rotary_angles(frame, direction);
            const double other = 1e-14 / distance_from_singular(frame, direction);
            EXPECT_NEAR(found.phi, given.phi, is_ca ? 1e-14 : other) << machine.word;
            EXPECT_NEAR(found.theta, given.theta, is_ca ? other : 1e-14) << machine.word;
        }
}

TEST(RotaryAngles, HaveASecondSolution)
{
    test::Random random{3};
    for (const RotaryFamily family : {RotaryFamily::CA, RotaryFamily::AB})
        for (int k = 0; k < 1000; ++k) {
            const RotaryFrame frame =
                frame_of(family == RotaryFamily::CA ? "cBb" : "aBb");
            const RotaryAngles given{random.uniform(-pi, pi), random.uniform(-pi, pi)};
            const RotaryAngles other = other_rotary_angles(family, given);
            EXPECT_LT((turned(frame, given) - turned(frame, other)).norm(), 1e-14);
            EXPECT_LE(std::abs(other.phi), pi);
            EXPECT_LE(std::abs(other.theta), pi);
            const RotaryAngles again = other_rotary_angles(family, other);
            EXPECT_NEAR(again.phi, given.phi, 1e-14);
            EXPECT_NEAR(again.theta, given.theta, 1e-14);
        }
}

TEST(RotaryAngles, AreFiniteAtSingularDirections)
{
    for (const MachineConfiguration& machine : valid_machines()) {
        const RotaryFrame frame = machine_frame(machine);
        for (const Vec3& direction : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{1, 0, 0},
                                      Vec3{-1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, -1, 0}}) {
            const RotaryAngles angles = rotary_angles(frame, direction);
            EXPECT_LT((turned(frame, angles) - direction).norm(), 1e-15) << machine.word;
        }
        const Vec3 singular =
            machine.family == RotaryFamily::CA ? Vec3{-frame.tool_axis} : frame.r1_axis;
        EXPECT_EQ(distance_from_singular(frame, singular), 0);
    }
    EXPECT_NEAR(rotary_angles(frame_of("abB"), Vec3{1, 0, 0}).theta, pi / 2, 1e-15);
}

// Half a turn of the part about the tool axis reverses both rotary axes, and in A,B both
// angles.
TEST(RotaryAngles, ChangeSignWithThePartHalfATurnAboutTheToolAxis)
{
    test::Random random{4};
    const Vec3 c = Vec3::Random().normalized();
    const Vec3 r1 = c.unitOrthogonal();
    const RotaryFrame frame{RotaryFamily::AB, c, r1, c.cross(r1)};
    const RotaryFrame reversed{RotaryFamily::AB, c, -r1, -c.cross(r1)};
    for (int k = 0; k < 100; ++k) {
        const Vec3 direction =
            turned(frame, {random.uniform(-3, 3), random.uniform(-1, 1)});
        const RotaryAngles there = rotary_angles(frame, direction);
        const RotaryAngles here = rotary_angles(reversed, direction);
        EXPECT_NEAR(there.phi, -here.phi, 1e-14);
        EXPECT_NEAR(there.theta, -here.theta, 1e-14);
    }
}

TEST(MachineFrame, OfFewerAxesRestsAtZero)
{
    const RotaryFrame four = machine_frame(configuration_from_word("W/bxyBz/T"));
    EXPECT_EQ(four.r1_axis, Vec3::UnitY());
    EXPECT_LT(
        (turned_tool_axis(four, {rad(30), 0}) - Vec3(0.5, 0, std::sqrt(0.75))).norm(),
        1e-15);
    EXPECT_EQ(turned_tool_axis(machine_frame(MachineConfiguration{}), {0, 0}),
              Vec3::UnitZ());
    EXPECT_THROW(machine_frame(configuration_from_word("W/acxyBz/T")), DomainError);
}

}  // namespace
}  // namespace endmill
