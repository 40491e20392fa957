// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_value.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

// The keys are tested with the tool file, whose reader calls this function too.
TEST(ToolValue, NeedsNeitherFormatNorName)
{
    const JsonDocument document{R"({"cutter": "ball:6", "length_mm": 80})", "t.json"};
    const Tool tool = tool_in(document.root(), {});
    EXPECT_EQ(tool.cutter, Cutter::ball(3));
    EXPECT_EQ(tool.length, 80);
    EXPECT_EQ(tool.name, "");
}

TEST(ToolValue, RefusesAnUnknownKey)
{
    const JsonDocument document{R"({"cutter": "ball:6", "lenght_mm": 80})", "t.json"};
    EXPECT_THAT(complaint_of([&] { tool_in(document.root(), {}); }),
                testing::HasSubstr("t.json:/lenght_mm: unknown key"));
}

}  // namespace
}  // namespace endmill
