// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/cutter/tool.h"

#include <cmath>
#include <functional>
#include <limits>

#include <gtest/gtest.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

Tool sound_tool()
{
    return {.cutter = Cutter::ball(5),
            .name = "sound",
            .flutes = 2,
            .helix = Angle::degrees(30),
            .length = 100,
            .limits = {.cutting_force_n = 1, .torque_n_m = 2},
            .shank = {{.diameter = 9, .from = 12, .to = 40}},
            .holder = {{.diameter = 24, .from = 40, .to = 60},
                       {.diameter = 30, .from = 60, .to = 80}}};
}

TEST(Tool, ACutterAloneIsSound)
{
    EXPECT_NO_THROW(require_sound(Tool{.cutter = Cutter::flat(1)}));
    EXPECT_NO_THROW(require_sound(sound_tool()));
}

TEST(Tool, RefusesInvalidTools)
{
    const double infinite = std::numeric_limits<double>::infinity();
    const std::function<void(Tool&)> faults[] = {
        [](Tool& tool) { tool.shank[0].diameter = 0; },
        [](Tool& tool) { tool.shank[0].diameter = std::nan(""); },
        [](Tool& tool) { tool.holder[1].from = 80; },
        [](Tool& tool) { tool.holder[0].from = -1; },
        [&](Tool& tool) { tool.holder[0].to = infinite; },
        [](Tool& tool) { tool.length = -1; },
        [&](Tool& tool) { tool.length = infinite; },
        [](Tool& tool) { tool.flutes = 0; },
        [](Tool& tool) { tool.helix = Angle::degrees(90); },
        [](Tool& tool) { tool.limits.thrust_n = 0; },
    };
    for (const auto& fault : faults) {
        Tool tool = sound_tool();
        fault(tool);
        EXPECT_THROW(require_sound(tool), DomainError);
    }
}

TEST(ToolBody, IsShankAndHolder)
{
    const Tool tool = sound_tool();
    const std::vector<ToolCylinder> body = tool_body(tool);
    ASSERT_EQ(body.size(), 3U);
    EXPECT_EQ(body[0], tool.shank[0]);
    EXPECT_EQ(body[2], tool.holder[1]);
    EXPECT_TRUE(tool_body(Tool{.cutter = Cutter::flat(1)}).empty());
}

}  // namespace
}  // namespace endmill
