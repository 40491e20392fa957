// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/setup/detail/range_limits.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

constexpr double degree = std::numbers::pi / 180;

TEST(RangeLimits, FollowTheFamily)
{
    const RotaryLimits limits{{-20 * degree, 130 * degree}, {-40 * degree, 100 * degree}};
    const RangeLimits ca{RotaryFamily::CA, limits};
    EXPECT_NEAR(ca.width, 140 * degree, 1e-15);
    EXPECT_NEAR(ca.far, 130 * degree, 1e-15);
    EXPECT_NEAR(ca.near, 20 * degree, 1e-15);
    const RangeLimits ab{RotaryFamily::AB, limits};
    EXPECT_NEAR(ab.width, 150 * degree, 1e-15);
    EXPECT_NEAR(ab.far, 90 * degree, 1e-15);  // cut at a quarter turn
    EXPECT_NEAR(ab.near, 40 * degree, 1e-15);
}

TEST(RangeLimits, HoldEitherTurnOfThePart)
{
    const RangeLimits limits{RotaryFamily::CA, {{-0.2, 1.0}, {-1, 1}}};
    EXPECT_TRUE(limits.hold(1.0, 0.2));
    EXPECT_TRUE(limits.hold(0.2, 1.0));
    EXPECT_FALSE(limits.hold(0.3, 0.3));
    EXPECT_FALSE(limits.hold(1.1, 0));
    EXPECT_TRUE(limits.hold(1.0 + turn_tolerance / 2, 0));
    EXPECT_GT(limits.widest(), limits.width);
    EXPECT_NEAR(limits.highest(), 1.2, 1e-8);
    EXPECT_NEAR(limits.farthest(), 1.0, 1e-8);
}

TEST(RangeLimits, LetTheLesserLevelRiseForTiltOnly)
{
    const RangeLimits limits{RotaryFamily::CA, {{-0.2, 1.0}, {-1, 1}}};
    const PoseMeasure tilt{RotaryFamily::CA, SetupObjective::Tilt, 0.1};
    EXPECT_TRUE(rises_freely(tilt, limits, 0.1, 0.5));
    EXPECT_FALSE(rises_freely(tilt, limits, 0.3, 0.5));   // exceeds the limits
    EXPECT_FALSE(rises_freely(tilt, limits, 0.1, 0.05));  // it is the larger level
    EXPECT_FALSE(rises_freely({}, limits, 0.1, 0.5));
}

}  // namespace
}  // namespace endmill
