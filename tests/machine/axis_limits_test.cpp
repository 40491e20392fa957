// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/axis_limits.h"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace endmill {
namespace {

using std::numbers::pi;
using testing::HasSubstr;

TEST(AxisLimits, ContainTheirEnds)
{
    const LinearLimits limits{LinearRange{-1, 1}, LinearRange{}, LinearRange{0, 0}};
    EXPECT_TRUE(is_within(limits, {1, 1e9, 0}));
    EXPECT_TRUE(is_within(limits, {-1, -1e9, 0}));
    EXPECT_FALSE(is_within(limits, {1.001, 0, 0}));
    EXPECT_FALSE(is_within(limits, {0, 0, -1e-9}));
}

TEST(AxisLimits, ContainATurnUpToWholeTurns)
{
    const RotaryRange range{-1.5 * pi, 0.25 * pi};
    EXPECT_EQ(turn_within(range, -pi), -pi);
    EXPECT_NEAR(turn_within(range, 0.75 * pi).value_or(0), -1.25 * pi, 1e-15);
    EXPECT_EQ(turn_within(range, 0.4 * pi), std::nullopt);
    EXPECT_TRUE(turn_within(range, 0.25 * pi + 0.9e-9).has_value());
    EXPECT_FALSE(turn_within(range, 0.25 * pi + 1.1e-9).has_value());
}

// Turning the part by q has the same effect as turning the tool by -q.
TEST(AxisLimits, AreMirroredOnThePartsSideOnly)
{
    EXPECT_EQ(mirrored(MachineSide::Head, RotaryRange{-1, 2}), (RotaryRange{-1, 2}));
    EXPECT_EQ(mirrored(MachineSide::Table, RotaryRange{-1, 2}), (RotaryRange{-2, 1}));
    EXPECT_EQ(mirrored(MachineSide::Table, 0.5), -0.5);
    EXPECT_FALSE(std::signbit(mirrored(MachineSide::Table, 0.0)));
}

TEST(AxisLimits, OfRotaryAxesContainZeroAndAreNoWiderThanATurn)
{
    EXPECT_EQ(expected_rotary_range(0, -270, 90), std::nullopt);
    EXPECT_EQ(expected_rotary_range(1, -180, 180), std::nullopt);
    EXPECT_EQ(expected_rotary_range(1, 0, 0), std::nullopt);
    EXPECT_THAT(expected_rotary_range(0, -270, 91).value_or(""), HasSubstr("360"));
    EXPECT_THAT(expected_rotary_range(1, -181, 0).value_or(""), HasSubstr("180"));
    EXPECT_THAT(expected_rotary_range(0, 1, 2).value_or(""), HasSubstr("hold 0"));
    EXPECT_THAT(expected_rotary_range(1, 30, -30).value_or(""), HasSubstr("hold 0"));
}

// Every turn of the wide range has an equal direction in the reduced one.
TEST(AxisLimits, BeyondARotationAreReducedToOne)
{
    EXPECT_EQ(within_one_rotation(0, {-4 * pi, 4 * pi}), RotaryRange{});
    EXPECT_EQ(within_one_rotation(0, {-1.5 * pi, 0.5 * pi}),
              (RotaryRange{-1.5 * pi, 0.5 * pi}));
    EXPECT_EQ(within_one_rotation(0, {-3 * pi, 0}), RotaryRange{});
    EXPECT_EQ(within_one_rotation(1, {-0.1, 2 * pi}), (RotaryRange{-0.1, pi}));
    EXPECT_EQ(within_one_rotation(1, {-1, 1}), (RotaryRange{-1, 1}));
}

TEST(AxisLimits, BelongToTheAxisThatTheFamilyDetermines)
{
    RotaryLimits limits;
    for (const char* word : {"W/caBxyz/T", "W/cxyBzb/T"}) {
        const MachineConfiguration ca = configuration_from_word(word);
        EXPECT_EQ(&turns_of(limits, ca, 0), &limits.theta);
        EXPECT_EQ(&turns_of(limits, ca, 1), &limits.phi);
    }
    const MachineConfiguration ba = configuration_from_word("W/baBxyz/T");
    EXPECT_EQ(&turns_of(limits, ba, 0), &limits.phi);
    EXPECT_EQ(&turns_of(limits, ba, 1), &limits.theta);
    const RotaryLimits fixed;
    EXPECT_EQ(&turns_of(fixed, ba, 1), &fixed.theta);
    const MachineConfiguration four = configuration_from_word("W/bBxyz/T");
    EXPECT_EQ(&turns_of(limits, four, 0), &limits.phi);
}

TEST(AxisLimits, OfMissingAxesAreZero)
{
    const RotaryRange none{0, 0};
    EXPECT_EQ(widest_limits(configuration_from_word("W/caBxyz/T")), RotaryLimits{});
    EXPECT_EQ(widest_limits(configuration_from_word("W/bBxyz/T")).theta, none);
    EXPECT_EQ(widest_limits(configuration_from_word("W/bBxyz/T")).phi, RotaryRange{});
    EXPECT_EQ(widest_limits(MachineConfiguration{}), (RotaryLimits{none, none}));
}

}  // namespace
}  // namespace endmill
