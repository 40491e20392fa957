// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string two_tools = R"({"format": "endmill-tools/1", "name": "n", "source": "s",
 "tools": [{"number": 12, "tool": {"cutter": "flat:8", "flutes": 2,
                                   "shank": [{"diameter_mm": 7, "from_mm": 9, "to_mm": 30}]}},
           {"number": 3, "tool": "ball:6"}]})";

std::string tool_table_complaint(const std::string& text)
{
    return complaint_of([&] { parse_tool_table(text, "tools.json"); });
}

TEST(ToolTable, HoldsCutterWordsAndTools)
{
    const std::vector<NumberedTool> tools = parse_tool_table(two_tools, "tools.json");
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].number, 3);
    EXPECT_EQ(tools[0].tool.cutter, Cutter::ball(3));
    EXPECT_EQ(tools[1].number, 12);
    EXPECT_EQ(tools[1].tool.cutter, Cutter::flat(4));
    EXPECT_EQ(tool_body(tools[1].tool).size(), 1U);
}

TEST(ToolTable, MayBeATableOfLinuxCnc)
{
    const std::vector<NumberedTool> tools =
        parse_tool_table("T2 D0.5 ;flat\nT1 D0.25 ;ball\n", "t.tbl", {{}, 25.4});
    ASSERT_EQ(tools.size(), 2U);
    EXPECT_EQ(tools[0].tool.cutter, Cutter::ball(0.125 * 25.4));
    EXPECT_EQ(tools[1].tool.cutter, Cutter::flat(0.25 * 25.4));
    EXPECT_EQ(tools[1].tool.name, "flat");
}

TEST(ToolTable, IsReadStrictly)
{
    EXPECT_THAT(
        tool_table_complaint(replaced(two_tools, "\"number\": 3", "\"number\": 12")),
        HasSubstr("tools.json:/tools/1/number: tool 12 a second time"));
    EXPECT_THAT(
        tool_table_complaint(replaced(two_tools, "\"number\": 3", "\"nummer\": 3")),
        HasSubstr("/tools/1/nummer: unknown key"));
    EXPECT_THAT(tool_table_complaint(replaced(two_tools, "ball:6", "ball:0")),
                HasSubstr("/tools/1/tool: \"ball:0\""));
    EXPECT_THAT(
        tool_table_complaint(replaced(two_tools, "\"number\": 3", "\"number\": -3")),
        HasSubstr("/tools/1/number: -3"));
    EXPECT_THAT(tool_table_complaint(replaced(two_tools, "\"flutes\"", "\"flute\"")),
                HasSubstr("/tools/0/tool/flute: unknown key"));
    EXPECT_THAT(tool_table_complaint(replaced(two_tools, "tools/1", "tools/2")),
                HasSubstr("newer version"));
    EXPECT_THAT(tool_table_complaint(R"({"format": "endmill-tools/1", "tools": []})"),
                HasSubstr("no tool; expected at least one"));
    EXPECT_THAT(tool_table_complaint("T1 P1\n"),
                HasSubstr("no row with a diameter; expected rows such as"));
    EXPECT_THAT(tool_table_complaint("T1 ;ball:6\nT1 ;ball:8\n"),
                HasSubstr("tools.json:2: tool 1 a second time"));
    EXPECT_THROW(parse_tool_table(two_tools, "t.json", {{}, 25.4}), DomainError);
}

}  // namespace
}  // namespace endmill
