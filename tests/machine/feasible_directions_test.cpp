// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/feasible_directions.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "endmill/core/angle.h"
#include "endmill/core/error.h"
#include "endmill/machine/axis_limits.h"
#include "endmill/machine/configuration.h"
#include "random.h"

namespace endmill {
namespace {

using std::numbers::pi;

const std::vector<DirectionCurve> the_pole{{Vec3{0, 0, 1}}};

double rad(double degrees)
{
    return Angle::degrees(degrees).radians();
}

RotaryRange range(double from_deg, double to_deg)
{
    return {rad(from_deg), rad(to_deg)};
}

FeasibleDirections feasible(const std::string& word, const RotaryLimits& limits)
{
    return feasible_directions(configuration_from_word(word), limits);
}

Vec3 spherical(double azimuth_deg, double polar_deg)
{
    const double s = std::sin(rad(polar_deg));
    return {s * std::cos(rad(azimuth_deg)), s * std::sin(rad(azimuth_deg)),
            std::cos(rad(polar_deg))};
}

Vec3 random_direction(test::Random& random)
{
    const double z = random.uniform(-1, 1);
    const double azimuth = random.uniform(0, 2 * pi);
    return {std::sqrt(1 - z * z) * std::cos(azimuth),
            std::sqrt(1 - z * z) * std::sin(azimuth), z};
}

// Source: docs/methods/five-axis-setup.md, section 9 (9.3).
TEST(FeasibleDirections, OfCBAreTwoSectors)
{
    const FeasibleDirections set =
        feasible("W/Bcbxyz/T", {.phi = range(-30, 60), .theta = range(-30, 60)});
    for (double azimuth = -30; azimuth <= 60; azimuth += 5)
        for (double polar = 0; polar <= 60; polar += 5) {
            EXPECT_TRUE(set.contains(spherical(azimuth, polar)));
            if (polar <= 30) {
                EXPECT_TRUE(set.contains(spherical(azimuth + 180, polar)));
            }
        }
    EXPECT_FALSE(set.contains(spherical(61, 10)));
    EXPECT_FALSE(set.contains(spherical(200, 31)));
    EXPECT_FALSE(set.contains(spherical(0, 60.1)));
    EXPECT_TRUE(set.contains(spherical(0, 60 + 5e-8)));   // 0.9e-9 rad
    EXPECT_FALSE(set.contains(spherical(0, 60 + 6e-8)));  // 1.05e-9 rad
    EXPECT_NEAR(set.solid_angle(), 0.9958449670, 1e-10);
}

TEST(FeasibleDirections, HaveTheSolidAnglesOfTheTable)
{
    EXPECT_NEAR(feasible("W/Babxyz/T", {.phi = range(-20, 50), .theta = range(-15, 30)})
                    .solid_angle(),
                0.9270723535, 1e-10);
    // C turns all the way round: the set is a cap of the larger tilt.
    EXPECT_NEAR(feasible("W/Bcaxyz/T", {.phi = range(-30, 60), .theta = range(-180, 180)})
                    .solid_angle(),
                2 * pi * (1 - std::cos(rad(60))), 1e-14);
    for (const char* pair : {"abB", "aBb", "Bab", "baB", "bBa", "Bba"})
        EXPECT_NEAR(
            feasible(whole_word(pair), {range(-30, 30), range(-30, 30)}).solid_angle(),
            4 * (pi / 6) * std::sin(rad(30)), 1e-14);
    for (const char* pair : {"caB", "cBa", "Bca", "cbB", "cBb", "Bcb"})
        EXPECT_NEAR(
            feasible(whole_word(pair), {range(-30, 30), range(-30, 30)}).solid_angle(),
            2 * (pi / 3) * (1 - std::cos(rad(30))), 1e-14);
}

// Closed forms at random limits. Source: docs/methods/five-axis-setup.md, section 3.
TEST(FeasibleDirections, HaveTheSolidAngleInClosedForm)
{
    test::Random random{5};
    for (int k = 0; k < 1000; ++k) {
        const RotaryRange wide{-random.uniform(0, pi), random.uniform(0, pi)};
        const double w = wide.to - wide.from;
        const RotaryRange tilt{-random.uniform(0, pi), random.uniform(0, pi)};
        const double larger = std::max(-tilt.from, tilt.to);
        const double smaller = std::min(-tilt.from, tilt.to);
        const double sectors =
            w <= pi ? w * ((1 - std::cos(larger)) + (1 - std::cos(smaller)))
                    : w * (1 - std::cos(larger)) + (2 * pi - w) * (1 - std::cos(smaller));
        EXPECT_NEAR(feasible("W/Bcaxyz/T", {.phi = tilt, .theta = wide}).solid_angle(),
                    sectors, 1e-13);
        const RotaryRange half{tilt.from / 2, tilt.to / 2};
        EXPECT_NEAR(feasible("W/Bbaxyz/T", {.phi = wide, .theta = half}).solid_angle(),
                    w * (std::sin(half.to) - std::sin(half.from)), 1e-13);
    }
}

// R2 without limits gives a pair of lunes through R1. The paper's figure 6 draws a band.
TEST(FeasibleDirections, OfR2WithoutLimitsAreAPairOfLunes)
{
    const FeasibleDirections set =
        feasible("W/Babxyz/T", {.phi = range(-20, 25), .theta = range(-180, 180)});
    EXPECT_NEAR(set.solid_angle(), 4 * rad(45), 1e-14);
    EXPECT_EQ(set.border(0.1).size(), 4U);
    const FeasibleDirections band =
        feasible("W/Babxyz/T", {.phi = range(-180, 180), .theta = range(-20, 25)});
    EXPECT_NEAR(band.solid_angle(), 2 * pi * (std::sin(rad(20)) + std::sin(rad(25))),
                1e-14);
    EXPECT_EQ(band.border(0.1).size(), 2U);
}

TEST(FeasibleDirections, WithoutLimitsAreAll)
{
    test::Random random{6};
    for (const char* pair : {"caB", "Bcb", "aBb", "baB"}) {
        const FeasibleDirections set = feasible(whole_word(pair), {});
        EXPECT_NEAR(set.solid_angle(), 4 * pi, 1e-13);
        EXPECT_TRUE(set.border(0.1).empty());
        for (int k = 0; k < 100; ++k)
            EXPECT_TRUE(set.contains(random_direction(random)));
        for (const Vec3& axis : {Vec3{1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, -1}})
            EXPECT_TRUE(set.contains(axis));
    }
}

RotaryLimits random_limits(RotaryFamily family, test::Random& random)
{
    const double from = -random.uniform(0, 2 * pi);
    const RotaryRange first{from, random.uniform(0, 2 * pi + from)};
    const RotaryRange second{-random.uniform(0, pi), random.uniform(0, pi)};
    return family == RotaryFamily::CA ? RotaryLimits{second, first}
                                      : RotaryLimits{first, second};
}

// The solid angle is compared with the share of random directions in the set, also for R2
// beyond a quarter turn.
TEST(FeasibleDirections, HaveTheSolidAngleOfTheirMembers)
{
    test::Random random{7};
    for (int k = 0; k < 40; ++k) {
        const RotaryFamily family = k % 2 == 0 ? RotaryFamily::CA : RotaryFamily::AB;
        const FeasibleDirections set = feasible(k % 2 == 0 ? "W/Bcbxyz/T" : "W/Bbaxyz/T",
                                                random_limits(family, random));
        constexpr int samples = 40'000;
        int hits = 0;
        for (int sample = 0; sample < samples; ++sample)
            hits += set.contains(random_direction(random)) ? 1 : 0;
        const double share = static_cast<double>(hits) / samples;
        const double deviation = std::sqrt(share * (1 - share) / samples);
        EXPECT_NEAR(set.solid_angle() / (4 * pi), share, 5 * deviation + 1e-4) << k;
    }
}

TEST(FeasibleDirections, ContainEveryDirectionOfTurnsWithinTheLimits)
{
    test::Random random{8};
    for (int k = 0; k < 200; ++k)
        for (const char* pair : {"Bca", "Bcb", "Bab", "Bba"}) {
            const MachineConfiguration machine =
                configuration_from_word(whole_word(pair));
            const RotaryLimits limits = random_limits(machine.family.value(), random);
            const FeasibleDirections set = feasible_directions(machine, limits);
            for (int turn = 0; turn < 10; ++turn)
                EXPECT_TRUE(set.contains(turned_tool_axis(
                    set.frame(), {random.uniform(limits.phi.from, limits.phi.to),
                                  random.uniform(limits.theta.from, limits.theta.to)})));
            EXPECT_TRUE(set.contains(set.frame().tool_axis));
        }
}

// Every point of the border belongs to the set. Close to it lie a direction of the set
// and a direction outside of it.
TEST(FeasibleDirections, EndAtTheirBorder)
{
    test::Random random{9};
    constexpr double aside = 1e-6;  // rad
    constexpr double step = 0.005;
    for (int k = 0; k < 200; ++k) {
        const RotaryFamily family = k % 2 == 0 ? RotaryFamily::CA : RotaryFamily::AB;
        const FeasibleDirections set = feasible(k % 2 == 0 ? "W/Bcbxyz/T" : "W/Bbaxyz/T",
                                                random_limits(family, random));
        const auto border = set.border(step);
        EXPECT_FALSE(border.empty());
        for (const DirectionCurve& curve : border) {
            ASSERT_GE(curve.size(), 2U);
            for (std::size_t i = 0; i + 1 < curve.size(); ++i) {
                EXPECT_TRUE(set.contains(curve[i]));
                EXPECT_NEAR(curve[i].norm(), 1, 1e-15);
                EXPECT_LE((curve[i + 1] - curve[i]).norm(), step + 1e-12);
            }
            const std::size_t middle = curve.size() / 2;
            const Vec3 along = curve[middle] - curve[middle - 1];
            if (curve.size() < 3 || along.norm() < 1e-4)
                continue;  // too close to a corner
            const Vec3 across = aside * curve[middle].cross(along.normalized());
            EXPECT_NE(set.contains((curve[middle] + across).normalized()),
                      set.contains((curve[middle] - across).normalized()))
                << k;
        }
    }
}

TEST(FeasibleDirections, OfAFourAxisMachineAreAnArc)
{
    const MachineConfiguration machine = configuration_from_word("W/axyBz/T");
    RotaryLimits limits = widest_limits(machine);
    limits.phi = range(-20, 90);
    const FeasibleDirections set = feasible_directions(machine, limits);
    EXPECT_EQ(set.solid_angle(), 0);
    EXPECT_TRUE(set.contains({0, -1, 0}));
    EXPECT_TRUE(set.contains({0, std::sin(rad(20)), std::cos(rad(20))}));
    EXPECT_FALSE(set.contains({0, std::sin(rad(21)), std::cos(rad(21))}));
    EXPECT_FALSE(set.contains(Vec3{1e-7, -1, 0}.normalized()));
    EXPECT_FALSE(set.contains({1, 0, 0}));
    const auto border = set.border(0.01);
    ASSERT_EQ(border.size(), 1U);
    EXPECT_LT((border[0].back() - Vec3(0, -1, 0)).norm(), 1e-15);
    for (const Vec3& direction : border[0])
        EXPECT_TRUE(set.contains(direction));
}

TEST(FeasibleDirections, OfAThreeAxisMachineAreAPoint)
{
    const MachineConfiguration machine;
    const FeasibleDirections set = feasible_directions(machine, widest_limits(machine));
    EXPECT_EQ(set.solid_angle(), 0);
    EXPECT_TRUE(set.contains({0, 0, 1}));
    EXPECT_FALSE(set.contains({0, 0, -1}));
    EXPECT_FALSE(set.contains(Vec3{1e-8, 0, 1}.normalized()));
    EXPECT_EQ(set.border(0.1), the_pole);
}

TEST(FeasibleDirections, WithOneAxisAtRestAreAnArcOrAPoint)
{
    const FeasibleDirections arc =
        feasible("W/Bcbxyz/T", {.phi = range(-20, 70), .theta = range(0, 0)});
    EXPECT_EQ(arc.solid_angle(), 0);
    ASSERT_EQ(arc.border(0.1).size(), 1U);
    EXPECT_LT((arc.border(0.1)[0].front() - spherical(180, 20)).norm(), 1e-15);
    EXPECT_LT((arc.border(0.1)[0].back() - spherical(0, 70)).norm(), 1e-15);
    const FeasibleDirections point =
        feasible("W/Bcbxyz/T", {.phi = range(0, 0), .theta = range(-90, 90)});
    EXPECT_EQ(point.border(0.1), the_pole);
    const FeasibleDirections of_r2 =
        feasible("W/Babxyz/T", {.phi = range(0, 0), .theta = range(-10, 15)});
    EXPECT_EQ(of_r2.border(0.1).size(), 1U);
}

TEST(FeasibleDirections, NeedLimitsThatContainZero)
{
    EXPECT_THROW(feasible("W/Bcbxyz/T", {.phi = range(1, 20)}), DomainError);
    EXPECT_THROW(feasible("W/Bcbxyz/T", {.phi = range(-181, 0)}), DomainError);
    EXPECT_THROW(feasible("W/Bcbxyz/T", {.theta = range(-181, 180)}), DomainError);
    EXPECT_NO_THROW(feasible("W/Bcbxyz/T", {.theta = range(-270, 90)}));
    EXPECT_THROW(feasible("W/Babxyz/T", {.theta = range(-270, 90)}), DomainError);
    EXPECT_THROW(feasible("W/Bcbxyz/T", {}).border(0), DomainError);
    EXPECT_THROW(feasible("W/acxyBz/T", {}), DomainError);
}

}  // namespace
}  // namespace endmill
