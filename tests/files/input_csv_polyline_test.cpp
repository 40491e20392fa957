// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/input_csv.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::HasSubstr;
using Points = std::vector<SectionPoint>;

std::string input_csv_polyline_complaint(const std::string& text)
{
    return complaint_of([&] { parse_polylines(text, "f.csv"); });
}

TEST(PolylineCsv, ReadsOneCurveInAnyOrderOfColumns)
{
    const auto curves = parse_polylines("z_mm,s_mm\r\n1,0\r\n-2.5,1e1\r\n", "f");
    ASSERT_EQ(curves.size(), 1U);
    EXPECT_EQ(curves[0].points, (Points{{0, 1}, {10, -2.5}}));
    EXPECT_FALSE(curves[0].is_closed);
}

TEST(PolylineCsv, TurnsMergesClosesAndOrders)
{
    const auto curves = parse_polylines(
        "curve,s_mm,z_mm\n7,5,0\n7,5,0\n7,2,1\n3,1,1\n3,0,0\n3,1,0\n3,1,1\n", "f");
    ASSERT_EQ(curves.size(), 2U);
    EXPECT_TRUE(curves[0].is_closed);
    EXPECT_EQ(curves[0].points, (Points{{0, 0}, {1, 0}, {1, 1}, {0, 0}}));
    EXPECT_EQ(curves[1].points, (Points{{2, 1}, {5, 0}}));
}

TEST(PolylineCsv, StatesTheLineOfAnError)
{
    EXPECT_THAT(input_csv_polyline_complaint(""), HasSubstr("f.csv:1: no column s_mm"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm\n"), HasSubstr("no column z_mm"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z\n"),
                HasSubstr("unknown column \"z\""));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm,s_mm\n"),
                HasSubstr("column s_mm twice"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n"),
                HasSubstr("no row after the header"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n1,2\n3\n"),
                HasSubstr("f.csv:3: row has 1 cell"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n1,nan\n"),
                HasSubstr("f.csv:2: z_mm is \"nan\""));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n,2\n"),
                HasSubstr("s_mm is empty"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n1e7,2\n"),
                HasSubstr("s_mm is 1e+07"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm,curve\n1,2,x\n"),
                HasSubstr("curve is \"x\"; expected a whole number"));
}

TEST(PolylineCsv, RefusesACurveWithoutTwoDifferentPoints)
{
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm\n1,2\n1,2\n"),
                HasSubstr("f.csv:2: a curve with 1 different point"));
    EXPECT_THAT(input_csv_polyline_complaint("s_mm,z_mm,curve\n0,0,1\n1,0,1\n5,5,2\n"),
                HasSubstr("f.csv:4: a curve with 1 different point"));
}

TEST(PolylineCsv, RefusesACurveThatComesAgain)
{
    EXPECT_THAT(input_csv_polyline_complaint(
                    "s_mm,z_mm,curve\n0,0,1\n1,0,1\n0,1,2\n1,1,2\n0,3,1\n"),
                HasSubstr("f.csv:6: curve 1 occurs again after another curve"));
}

TEST(PolylineCsv, MeasuresMemoryBeforeItReads)
{
    ReadLimits limits;
    limits.max_memory_gib = 1e-9;
    EXPECT_THROW(parse_polylines("s_mm,z_mm\n0,0\n1,1\n", "f", limits), LimitError);
}

TEST(PolylineCsv, ReadsAFile)
{
    const TemporaryFolder folder;
    EXPECT_THROW(read_polylines(folder.path() / "none.csv"), FormatError);
}

}  // namespace
}  // namespace endmill
