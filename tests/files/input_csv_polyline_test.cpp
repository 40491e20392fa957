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

TEST(PolylineCsv, ReadsTheCurvesOfEachPlaneAsIfTheyStoodAlone)
{
    const std::string one = "1,5,0\n1,2,1\n0,3,0\n0,4,4\n";
    const std::string other = "1,0,0\n1,9,9\n";
    const auto with_plane = [](const std::string& number, const std::string& rows) {
        std::string text = number + "," + rows;
        for (std::size_t at = 0; (at = text.find('\n', at) + 1) < text.size();)
            text.insert(at, number + ",");
        return text;
    };
    const std::string header = "curve,s_mm,z_mm\n";
    const auto planes = parse_polyline_planes(
        "plane," + header + with_plane("7", one) + with_plane("2", other), "f");
    ASSERT_EQ(planes.size(), 2U);
    for (const auto& [text, curves] :
         {std::pair{one, planes[0]}, std::pair{other, planes[1]}}) {
        const auto alone = parse_polylines(header + text, "f");
        ASSERT_EQ(curves.size(), alone.size());
        for (std::size_t k = 0; k < curves.size(); ++k)
            EXPECT_EQ(curves[k].points, alone[k].points);
        EXPECT_EQ(parse_polyline_planes(header + text, "f").size(), 1U);
    }
}

TEST(PolylineCsv, RefusesAPlaneThatComesAgainAndAPlaneWhereThereIsOne)
{
    const auto complaint = [](const std::string& text) {
        return complaint_of([&] { parse_polyline_planes(text, "f.csv"); });
    };
    EXPECT_THAT(complaint("plane,s_mm,z_mm\n1,0,0\n1,1,0\n2,0,0\n2,1,0\n1,5,0\n1,6,0\n"),
                HasSubstr("f.csv:6: plane 1 occurs again after another plane"));
    EXPECT_THAT(complaint("plane,s_mm,z_mm\n1,0,0\n2,0,0\n"),
                HasSubstr("f.csv:2: a curve with 1 different point"));
    EXPECT_THAT(complaint("plane,s_mm,z_mm\n-1,0,0\n"),
                HasSubstr("plane is \"-1\"; expected a whole number"));
    EXPECT_THAT(input_csv_polyline_complaint("plane,s_mm,z_mm\n1,0,0\n1,1,1\n"),
                HasSubstr("unknown column \"plane\""));
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
