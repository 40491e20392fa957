// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <cmath>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string whole_tool = R"({"format": "endmill-tool/1", "name": "long one",
 "source": "test", "cutter": "bull:10:2", "flutes": 3, "helix_deg": -30,
 "length_mm": 120, "limits": {"thrust_n": 200},
 "shank": [{"diameter_mm": 9, "from_mm": 15, "to_mm": 40}],
 "holder": [{"diameter_mm": 25, "from_mm": 40, "to_mm": 70}]})";

TEST(ToolFile, HoldsATool)
{
    const Tool tool = parse_tool(whole_tool, "tool.json");
    EXPECT_EQ(tool.cutter, (Cutter{5, 2}));
    EXPECT_EQ(tool.name, "long one");
    EXPECT_EQ(tool.flutes, 3);
    ASSERT_TRUE(tool.helix);
    EXPECT_NEAR(tool.helix->degrees(), -30, 1e-13);
    EXPECT_EQ(tool.length, 120);
    EXPECT_EQ(tool.limits, (LoadLimits{.thrust_n = 200}));
    ASSERT_EQ(tool.shank.size(), 1U);
    EXPECT_EQ(tool.shank[0], (ToolCylinder{.diameter = 9, .from = 15, .to = 40}));
    ASSERT_EQ(tool.holder.size(), 1U);
    EXPECT_EQ(tool.holder[0], (ToolCylinder{.diameter = 25, .from = 40, .to = 70}));
    EXPECT_NO_THROW(require_sound(tool));
}

TEST(ToolFile, NeedsACutterOnly)
{
    const Tool tool =
        parse_tool(R"({"format": "endmill-tool/1", "cutter": "ball:6"})", "six.json");
    EXPECT_EQ(tool.cutter, Cutter::ball(3));
    EXPECT_EQ(tool.name, "six");
    EXPECT_FALSE(tool.flutes);
    EXPECT_EQ(tool.length, 0);
    EXPECT_TRUE(tool_body(tool).empty());
    EXPECT_TRUE(std::isinf(tool.cutting_length));
}

TEST(ToolFile, CuttingLengthHoldsAtLeastTheRoundedCorner)
{
    const auto with = [](const std::string& length) {
        return replaced(whole_tool, "\"length_mm\"",
                        "\"cutting_length_mm\": " + length + ", \"length_mm\"");
    };
    EXPECT_EQ(parse_tool(with("2"), "tool.json").cutting_length, 2);
    EXPECT_EQ(parse_tool(with("22.5"), "tool.json").cutting_length, 22.5);
    EXPECT_THAT(
        complaint_of([&] { parse_tool(with("1.9"), "tool.json"); }),
        HasSubstr("tool.json:/cutting_length_mm: 1.9; expected at least the corner "
                  "radius of the cutter, 2 mm"));
    EXPECT_THAT(complaint_of([&] { parse_tool(with("0"), "tool.json"); }),
                HasSubstr("tool.json:/cutting_length_mm"));
}

struct Fault {
    std::string from;
    std::string to;
    std::string complaint;
};

class ToolFileWith : public testing::TestWithParam<Fault> {};

TEST_P(ToolFileWith, IsRefusedWithThePlace)
{
    const Fault& fault = GetParam();
    const std::string text = replaced(whole_tool, fault.from, fault.to);
    ASSERT_FALSE(text.empty());
    EXPECT_THAT(complaint_of([&] { parse_tool(text, "tool.json"); }),
                HasSubstr(fault.complaint));
}

INSTANTIATE_TEST_SUITE_P(
    AFault, ToolFileWith,
    testing::Values(
        Fault{"tool/1", "tool/2", "made by a newer version"},
        Fault{"tool/1", "machine/1", "E_FORMAT"},
        Fault{"bull:10:2", "bull:10:6", "/cutter"}, Fault{"bull:10:2", "10", "/cutter"},
        Fault{"\"flutes\": 3", "\"flutes\": 0", "/flutes"},
        Fault{"\"flutes\": 3", "\"flutes\": 2.9", "/flutes"},
        Fault{"\"flutes\": 3", "\"flute\": 3", "flutes"},
        Fault{"-30", "95", "/helix_deg"}, Fault{"120", "-1", "/length_mm"},
        Fault{"120", "1e7", "/length_mm"}, Fault{"200", "0", "/limits/thrust_n"},
        Fault{"\"diameter_mm\": 9", "\"diameter_mm\": 0", "/shank/0/diameter_mm"},
        Fault{"\"to_mm\": 40", "\"to_mm\": 15", "/shank/0/to_mm"},
        Fault{"\"from_mm\": 40", "\"from_mm\": -1", "/holder/0/from_mm"},
        Fault{"\"from_mm\": 40,", "", "from_mm"},
        Fault{"[{\"diameter_mm\": 9", "[[{", "E_JSON"},
        Fault{"{\"format\"", "solid {\"format\"", "E_FORMAT"}));

TEST(ToolFile, TheExampleIsRead)
{
    const Tool tool = read_tool(std::string{ENDMILL_SOURCE_DIR} +
                                "/datasets/tools/ball-10-shrink-fit.json");
    EXPECT_EQ(tool.cutter, Cutter::ball(5));
    EXPECT_EQ(tool_body(tool).size(), 3U);
    EXPECT_NO_THROW(require_sound(tool));
    EXPECT_THAT(complaint_of([] { read_tool("no such tool.json"); }),
                HasSubstr("E_OPEN"));
}

}  // namespace
}  // namespace endmill
