// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/process/milling_data.h"

#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "milling_examples.h"

namespace endmill {
namespace {

TEST(MillingTool, CopiesTheDataOfTheTool)
{
    const Tool tool{
        .cutter = Cutter::ball(4),
        .flutes = 3,
        .helix = Angle::degrees(30),
        .limits = {.cutting_force_n = 1200, .thrust_n = 450, .torque_n_m = 20}};
    const MillingTool seen = milling_tool(tool);
    EXPECT_EQ(seen.radius, 4);
    EXPECT_EQ(seen.flutes, 3);
    EXPECT_DOUBLE_EQ(seen.helix, std::numbers::pi / 6);
    EXPECT_EQ(seen.limits.cutting_force_n, 1200);
    EXPECT_EQ(seen.limits.thrust_n, 450);
    EXPECT_EQ(seen.limits.torque_n_m, 20);
}

TEST(MillingTool, WithoutLimitsHasNone)
{
    const MillingTool seen = milling_tool({.cutter = Cutter::ball(4), .flutes = 1});
    EXPECT_FALSE(seen.limits.cutting_force_n || seen.limits.thrust_n ||
                 seen.limits.torque_n_m);
    EXPECT_EQ(seen.helix, 0);
}

TEST(MillingTool, RefusesOtherCuttersAndUnknownFlutes)
{
    for (const Cutter& cutter : {Cutter::flat(5), Cutter{5, 2}}) {
        try {
            milling_tool({.cutter = cutter, .flutes = 2});
            FAIL() << "accepted";
        } catch (const DomainError& error) {
            EXPECT_NE(std::string{error.what()}.find(cutter_word(cutter)),
                      std::string::npos);
        }
    }
    EXPECT_THROW(milling_tool({.cutter = Cutter::ball(5)}), DomainError);
    EXPECT_THROW(milling_tool({.cutter = Cutter::ball(5), .flutes = 0}), DomainError);
}

TEST(MillingTool, RefusesNumbersOutOfRange)
{
    EXPECT_NO_THROW(require_sound(test::ball_10()));
    const auto refused = [](auto change) {
        MillingTool tool = test::ball_10();
        change(tool);
        EXPECT_THROW(require_sound(tool), DomainError);
    };
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const double radius : {0.0, -1.0, nan})
        refused([&](MillingTool& tool) { tool.radius = radius; });
    for (const double helix : {std::numbers::pi / 2, -2.0, nan})
        refused([&](MillingTool& tool) { tool.helix = helix; });
    for (const double limit : {0.0, -1.0, nan}) {
        refused([&](MillingTool& tool) { tool.limits.cutting_force_n = limit; });
        refused([&](MillingTool& tool) { tool.limits.thrust_n = limit; });
        refused([&](MillingTool& tool) { tool.limits.torque_n_m = limit; });
    }
    refused([](MillingTool& tool) { tool.flutes = 0; });
}

}  // namespace
}  // namespace endmill
