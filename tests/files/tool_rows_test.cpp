// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_rows.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

constexpr double mm = 1;
constexpr double inch = 25.4;

std::vector<ToolRow> rows(const std::string& text, std::optional<double> unit = mm)
{
    return tool_rows(text, "t.tbl", unit, 1e6);
}

std::string tool_rows_complaint(const std::string& text)
{
    return complaint_of([&] { rows(text); });
}

TEST(ToolRows, AreFlatEndMillsWithoutAnotherWord)
{
    const std::vector<ToolRow> found =
        rows("; a table\nT1 P1 D6 Z40 ;roughing\r\n\nt2 p7 d+2.5 q0 I+0 J+0\n");
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].number, 1);
    EXPECT_EQ(found[0].cutter, Cutter::flat(3));
    EXPECT_EQ(found[0].name, "roughing");
    EXPECT_EQ(found[1].number, 2);
    EXPECT_EQ(found[1].cutter, Cutter::flat(1.25));
    EXPECT_EQ(found[1].line, 4U);
}

TEST(ToolRows, HaveTheCutterOfTheirComment)
{
    const std::vector<ToolRow> found = rows(
        "T1 D10 ; ball\nT2 D0.5;flat:12.7\nT3 ;bull:8:1.5 for floors\nT4 P4 ;drill\n",
        inch);
    ASSERT_EQ(found.size(), 3U);  // T4 has no diameter
    EXPECT_EQ(found[0].cutter, Cutter::ball(5 * inch));
    EXPECT_EQ(found[1].cutter, Cutter::flat(0.25 * inch));
    EXPECT_EQ(found[2].cutter, (Cutter{4, 1.5}));
}

TEST(ToolRows, NeedAUnitOnlyForDiameters)
{
    EXPECT_EQ(rows("T1 P1 ;ball:6", std::nullopt).size(), 1U);
    EXPECT_EQ(rows("T1 D0.236 ;ball:6", std::nullopt)[0].cutter, Cutter::ball(3));
    EXPECT_THROW(rows("T1 D6", std::nullopt), DomainError);
}

TEST(ToolRows, AreReadStrictly)
{
    EXPECT_THAT(tool_rows_complaint("T1 D6\nP2 D6\n"),
                HasSubstr("t.tbl:2: a row without T; expected"));
    EXPECT_THAT(tool_rows_complaint("T1 K6"), HasSubstr("t.tbl:1: \"K6\"; expected"));
    EXPECT_THAT(tool_rows_complaint("T1 D6,5"), HasSubstr("\"D6,5\""));
    EXPECT_THAT(tool_rows_complaint("T1 D"), HasSubstr("\"D\""));
    EXPECT_THAT(tool_rows_complaint("T1 Dnan"), HasSubstr("\"Dnan\""));
    EXPECT_THAT(tool_rows_complaint("T1 D6 D7"), HasSubstr("two words D"));
    EXPECT_THAT(tool_rows_complaint("T1.5 D6"), HasSubstr("T1.5; expected a whole"));
    EXPECT_THAT(tool_rows_complaint("T-1 D6"), HasSubstr("T-1; expected a whole"));
    EXPECT_THAT(tool_rows_complaint("T1 D-6"), HasSubstr("D-6; expected a diameter"));
    EXPECT_THAT(tool_rows_complaint("T1 D1e9"),
                HasSubstr("1e+09 mm; expected at most 1e+06 mm"));
    EXPECT_THAT(tool_rows_complaint("T1 ;ball:"), HasSubstr("expected ball:DIAMETER"));
    EXPECT_THAT(tool_rows_complaint("T1 D8 ;ball:6"),
                HasSubstr("D is 8 mm and the comment names ball:6"));
}

}  // namespace
}  // namespace endmill
