// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/machine/axis_limits.h"

#include <numbers>

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(RotaryLimits, AreAWholeTurnByDefault)
{
    const RotaryLimits limits;
    EXPECT_EQ(limits.phi, limits.theta);
    EXPECT_EQ(limits.phi.to - limits.phi.from, 2 * std::numbers::pi);
    EXPECT_EQ(limits.phi.to, -limits.phi.from);
    EXPECT_NE(limits, (RotaryLimits{.phi = {0, 0}}));
}

}  // namespace
}  // namespace endmill
