// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/machining_data.h"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

const std::string whole = R"({"format": "endmill-control/1", "name": "a mill",
 "source": "a test", "extension": ".tap", "percent": false, "program_number": 12,
 "comments": "semicolon", "capital_comments": true, "start": ["G90", "G17 G40"],
 "end": ["M5", "M2"], "path_control": "exact", "tool_change": "M06",
 "tool_length": "G43", "first_axes": "xy", "dwell": "ms", "flood": "M8", "mist": "M7", "coolant_off": "M09",
 "arcs": "radius", "decimals_mm": 3, "decimals_inch": 4, "speed_decimals": 0,
 "always_point": true, "line_end": "crlf", "longest_line": 80,
 "largest_line_number": 9999})";

TEST(ControlFile, HoldsAControl)
{
    const Control control = parse_control(whole, "c.json");
    EXPECT_EQ(control.name, "a mill");
    EXPECT_EQ(control.source, "a test");
    EXPECT_EQ(control.extension, ".tap");
    EXPECT_FALSE(control.percent);
    EXPECT_EQ(control.program_number, 12);
    EXPECT_EQ(control.comments, CommentStyle::Semicolon);
    EXPECT_TRUE(control.capital_comments);
    EXPECT_EQ(control.start, (std::vector<std::string>{"G90", "G17 G40"}));
    EXPECT_EQ(control.end, (std::vector<std::string>{"M5", "M2"}));
    EXPECT_EQ(control.path_control, PathControl::Exact);
    EXPECT_EQ(control.tool_change, "M06");
    EXPECT_EQ(control.tool_length, "G43");
    EXPECT_EQ(control.first_axes, FirstAxes::Xy);
    EXPECT_EQ(control.dwell, DwellUnit::Milliseconds);
    EXPECT_EQ(control.flood, "M8");
    EXPECT_EQ(control.mist, "M7");
    EXPECT_EQ(control.coolant_off, "M09");
    EXPECT_EQ(control.arcs, ArcForm::Radius);
    EXPECT_EQ(control.decimals_mm, 3);
    EXPECT_EQ(control.decimals_inch, 4);
    EXPECT_EQ(control.speed_decimals, 0);
    EXPECT_TRUE(control.always_point);
    EXPECT_TRUE(control.crlf);
    EXPECT_EQ(control.longest_line, 80U);
    EXPECT_EQ(control.largest_line_number, 9999);
    EXPECT_NO_THROW(require_sound(control));
}

TEST(ControlFile, NeedsFewKeys)
{
    const Control control = parse_control(
        R"({"format": "endmill-control/1", "extension": ".nc", "start": [], "end": ["M2"]})",
        "folder/old.json");
    EXPECT_EQ(control.name, "old");
    EXPECT_TRUE(control.percent);
    EXPECT_FALSE(control.tool_change || control.tool_length || control.dwell ||
                 control.flood || control.mist || control.program_number ||
                 control.speed_decimals || control.longest_line);
    EXPECT_EQ(control.arcs, ArcForm::None);
    EXPECT_EQ(control.path_control, PathControl::None);
    EXPECT_EQ(control.first_axes, FirstAxes::Z);
    EXPECT_EQ(control.decimals_mm, 4);
    EXPECT_EQ(control.decimals_inch, 5);
}

TEST(ControlFile, OfEveryDatasetIsSound)
{
    const auto folder = std::filesystem::path{ENDMILL_SOURCE_DIR} / "datasets/controls";
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator{folder}) {
        if (entry.path().extension() != ".json")
            continue;
        ++files;
        const Control control = read_control(entry.path());
        EXPECT_NO_THROW(require_sound(control)) << entry.path();
        EXPECT_FALSE(control.source.empty());
    }
    EXPECT_EQ(files, 3);
}

struct Fault {
    std::string from;
    std::string to;
    std::string complaint;
};

class ControlFileWith : public testing::TestWithParam<Fault> {};

TEST_P(ControlFileWith, IsRefusedWithThePlace)
{
    const Fault& fault = GetParam();
    const std::string text = replaced(whole, fault.from, fault.to);
    ASSERT_FALSE(text.empty());
    EXPECT_THAT(complaint_of([&] { parse_control(text, "c.json"); }),
                HasSubstr(fault.complaint));
}

INSTANTIATE_TEST_SUITE_P(
    AFault, ControlFileWith,
    testing::Values(
        Fault{"endmill-control/1", "endmill-tool/1", "E_FORMAT"},
        Fault{"endmill-control/1", "endmill-control/2", "newer version"},
        Fault{"\"mist\"", "\"mists\"", "did you mean"},
        Fault{"\"extension\": \".tap\",", "", "extension"},
        Fault{".tap", "tap", "E_CONTROL c.json:/extension"},
        Fault{".tap", ".", "E_CONTROL c.json:/extension"},
        Fault{".tap", "../x", "E_CONTROL c.json:/extension"},
        Fault{".tap", ".longestnc", "E_CONTROL c.json:/extension"},
        Fault{"false", "\"no\"", "c.json:/percent: \"no\"; expected true or false"},
        Fault{"12,", "0,", "c.json:/program_number: 0; expected a whole number"},
        Fault{"\"semicolon\"", "\"semicolons\"", "did you mean \"semicolon\"?"},
        Fault{"G17 G40", "G17 G1",
              "E_CONTROL c.json:/start/1: G1 in a block at the start"},
        Fault{"G17 G40", "G21",
              "E_CONTROL c.json:/start/1: G21 in a block at the start; expected no unit: "
              "--units writes G20 or G21"},
        Fault{", \"M2\"", "",
              "E_CONTROL c.json:/end: no block with M2 or M30; expected one that ends"},
        Fault{"[\"M5\", \"M2\"]", "[]", "E_CONTROL c.json:/end"},
        Fault{"\"xy\"", "\"yx\"", "c.json:/first_axes: \"yx\"; expected"},
        Fault{"G17 G40", "X0", "E_CONTROL c.json:/start/1: X0 in a block at the start"},
        Fault{"G17 G40", "(G17)", "E_CONTROL c.json:/start/1"},
        Fault{"G17 G40", "G17\\nG0 Z-9", "E_CONTROL c.json:/start/1"},
        Fault{"G17 G40", "", "E_CONTROL c.json:/start/1"},
        Fault{"[\"M5\", \"M2\"]", "\"M2\"", "c.json:/end"},
        Fault{"\"M2\"", "\"m2\"", "E_CONTROL c.json:/end/1: \"m2\"; expected words"},
        Fault{"\"M2\"", "\"O1 CALL\"", "E_CONTROL c.json:/end/1"},
        Fault{"\"exact\"", "\"exakt\"", "did you mean \"exact\"?"},
        Fault{"M06", "M6 G0 Z-9", "E_CONTROL c.json:/tool_change"},
        Fault{"M06", "T1", "E_CONTROL c.json:/tool_change"},
        Fault{".tap", ".json",
              "c.json:/extension: \".json\"; expected an extension other"},
        Fault{".tap", ".csv", "c.json:/extension: \".csv\"; expected an extension other"},
        Fault{"G17 G40", "G17 G91.", "E_CONTROL c.json:/start/1: G91. in a block"},
        Fault{"G17 G40", "G65 P9000", "E_CONTROL c.json:/start/1: G65 in a block"},
        Fault{"M06", "M3", "neither stops, ends, calls a program nor turns the spindle"},
        Fault{"M09", "M30", "c.json:/coolant_off: \"M30\"; expected an M word that"},
        Fault{"G43", "G0", "c.json:/tool_length: \"G0\"; expected \"G43\""},
        Fault{"G43", "M43", "E_CONTROL c.json:/tool_length"},
        Fault{"\"ms\"", "\"min\"", "c.json:/dwell: \"min\"; expected"},
        Fault{"\"M8\"", "\"\"", "E_CONTROL c.json:/flood"},
        Fault{"\"radius\"", "\"R\"", "c.json:/arcs"},
        Fault{"\"decimals_mm\": 3", "\"decimals_mm\": 10", "c.json:/decimals_mm: 10"},
        Fault{"\"decimals_inch\": 4", "\"decimals_inch\": 4.5", "c.json:/decimals_inch"},
        Fault{"80", "39", "c.json:/longest_line: 39; expected a whole number from 40"},
        Fault{"9999", "0", "c.json:/largest_line_number"},
        Fault{"\"crlf\"", "\"cr\"", "c.json:/line_end"}));

}  // namespace
}  // namespace endmill
