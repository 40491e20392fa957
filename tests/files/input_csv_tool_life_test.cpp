// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string input_csv_tool_life_complaint(const std::string& text)
{
    return complaint_of([&] { parse_cutting_speeds(text, "f.csv"); });
}

std::string complaint_about_rows(const std::string& rows)
{
    return input_csv_tool_life_complaint("phi_over_pi,v_m_per_min\n" + rows);
}

TEST(ToolLifeCsv, ReadsColumnsInAnyOrder)
{
    EXPECT_THAT(
        parse_cutting_speeds("v_m_per_min,phi_over_pi\r\n64,0.1\r\n37,1\r\n", "f"),
        ElementsAre(CuttingSpeedDatum{0.1, 64}, CuttingSpeedDatum{1, 37}));
    EXPECT_EQ(complaint_about_rows("0.1,64\n0.1,60\n0.5,37"), "accepted");
}

TEST(ToolLifeCsv, StatesTheLineOfAnError)
{
    EXPECT_THAT(input_csv_tool_life_complaint(""),
                HasSubstr("f.csv:1: no column phi_over_pi"));
    EXPECT_THAT(input_csv_tool_life_complaint("phi_over_pi\n0.1\n"),
                HasSubstr("no column v_m_per_min"));
    EXPECT_THAT(input_csv_tool_life_complaint("phi_over_pi,v_m_per_mim\n"),
                HasSubstr("did you mean \"v_m_per_min\"?"));
    EXPECT_THAT(input_csv_tool_life_complaint("x,v_m_per_min\n"),
                testing::EndsWith("unknown column \"x\"; expected phi_over_pi and "
                                  "v_m_per_min"));
    EXPECT_THAT(input_csv_tool_life_complaint("phi_over_pi,phi_over_pi\n"),
                HasSubstr("column phi_over_pi twice"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n0.2\n"),
                HasSubstr("E_CSV f.csv:3: row has 1 cell; expected 2"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n0.2,1,2\n"), HasSubstr("row has 3 cells"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n\n"), HasSubstr("f.csv:3: row has 1 cell"));
    for (const std::string wrong : {"0", "-0.1", "1.0000001", "nan", "inf", "x", "0,1"})
        EXPECT_THAT(complaint_about_rows("0.1,64\n" + wrong + ",50\n"),
                    HasSubstr("f.csv:3:"));
    for (const std::string wrong : {"0", "-5", "nan", "inf", "1e7", "5 m"})
        EXPECT_THAT(complaint_about_rows("0.1,64\n0.2," + wrong + "\n"),
                    HasSubstr("f.csv:3: v_m_per_min is \"" + wrong + "\""));
    EXPECT_THAT(complaint_about_rows("0.1,64\n,50\n"), HasSubstr("phi_over_pi is empty"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n\"0.2,50\n"), HasSubstr("not closed"));
}

TEST(ToolLifeCsv, NeedsTwoDifferentAngles)
{
    EXPECT_THAT(complaint_about_rows(""), HasSubstr("no row after the header"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n"), HasSubstr("one row after the header"));
    EXPECT_THAT(complaint_about_rows("0.1,64\n0.1,60\n"),
                HasSubstr("the same in all rows"));
}

TEST(ToolLifeCsv, MeasuresMemoryBeforeItReads)
{
    EXPECT_THROW(parse_cutting_speeds("phi_over_pi,v_m_per_min\n0.1,64\n0.5,37\n", "f",
                                      {.max_memory_gib = 1e-9}),
                 LimitError);
}

TEST(ToolLifeCsv, ThePrintedDataAreRead)
{
    const auto data = read_cutting_speeds(std::string{ENDMILL_SOURCE_DIR} +
                                          "/datasets/materials/steel-cutting-speeds.csv");
    EXPECT_THAT(
        data,
        ElementsAre(CuttingSpeedDatum{0.1168859, 64}, CuttingSpeedDatum{0.2048328, 49},
                    CuttingSpeedDatum{0.3333334, 43}, CuttingSpeedDatum{0.5000001, 37}));
    EXPECT_THAT(complaint_of([] { read_cutting_speeds("no such file.csv"); }),
                HasSubstr("E_OPEN"));
}

}  // namespace
}  // namespace endmill
