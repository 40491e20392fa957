// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/tool_path_columns.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using enum PathColumn;
using testing::HasSubstr;

PathColumns columns_of(const std::string& header)
{
    CsvLines lines{header, "f"};
    lines.next();
    return path_columns(lines);
}

std::string tool_path_columns_complaint(const std::string& header)
{
    return complaint_of([&] { columns_of(header); });
}

TEST(PathColumns, StandWhereTheHeaderHasThem)
{
    const PathColumns columns =
        columns_of("limit,tip_z_mm,tip_x_mm,tip_y_mm,feed_mm_per_min");
    EXPECT_EQ(columns.count(), 5U);
    EXPECT_EQ(columns.place(Limit), 0U);
    EXPECT_EQ(columns.place(TipX), 2U);
    EXPECT_EQ(columns.place(Feed), 4U);
    EXPECT_FALSE(columns.has(MoveWord) || columns.has_contacts());
}

TEST(PathColumns, AreNamedInTheOrderOfTheFormat)
{
    std::string all;
    for (std::size_t c = 0; c < path_column_count; ++c)
        all += std::string{c == 0 ? "" : ","} +
               std::string{column_name(static_cast<PathColumn>(c))};
    EXPECT_EQ(
        all,
        "pass,point,move,tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_y,axis_z,tool,patch,"
        "u,v,contact_x_mm,contact_y_mm,contact_z_mm,normal_x,normal_y,normal_z,"
        "feed_mm_per_min,spindle_rpm,limit,x_mm,y_mm,z_mm,r1_deg,r2_deg");
    const PathColumns columns = columns_of(all);
    EXPECT_EQ(columns.count(), path_column_count);
    EXPECT_TRUE(columns.has_contacts());
}

TEST(PathColumns, RefuseAMissingUnit)
{
    EXPECT_EQ(tool_path_columns_complaint("tip_x,tip_y_mm,tip_z_mm"),
              "E_CSV f:1: column \"tip_x\" without its unit; expected \"tip_x_mm\"");
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,feed"),
                HasSubstr("expected \"feed_mm_per_min\""));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,spindle"),
                HasSubstr("expected \"spindle_rpm\""));
}

TEST(PathColumns, RefuseUnknownNamesWithASuggestion)
{
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_nm"),
                HasSubstr("unknown column \"tip_z_nm\""));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_nm"),
                HasSubstr("did you mean \"tip_z_mm\"?"));
    EXPECT_THAT(tool_path_columns_complaint("plane,curve"),
                HasSubstr("unknown column \"plane\""));
    EXPECT_THAT(tool_path_columns_complaint(std::string(100000, 'x')),
                HasSubstr("unknown column"));
    EXPECT_THAT(tool_path_columns_complaint("1,2,3"), HasSubstr("unknown column \"1\""));
}

TEST(PathColumns, NameThePointThatACoordinateMayMean)
{
    for (const char* header : {"x,y,z", "X,Y,Z"}) {
        EXPECT_THAT(
            tool_path_columns_complaint(header),
            HasSubstr("x, y and z of the tip are tip_x_mm, tip_y_mm and tip_z_mm"));
        EXPECT_THAT(tool_path_columns_complaint(header), HasSubstr("spindle_rpm"));
    }
}

TEST(PathColumns, RefuseMissingAndRepeatedColumns)
{
    EXPECT_EQ(
        tool_path_columns_complaint("tip_x_mm,tip_z_mm"),
        "E_CSV f:1: no column \"tip_y_mm\"; expected a header with tip_x_mm, tip_y_mm "
        "and tip_z_mm");
    EXPECT_THAT(tool_path_columns_complaint("pass,point"),
                HasSubstr("no column \"tip_x_mm\""));
    EXPECT_THAT(tool_path_columns_complaint(""), HasSubstr("no column \"tip_x_mm\""));
    EXPECT_THAT(tool_path_columns_complaint("\n"), HasSubstr("a column without a name"));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,"),
                HasSubstr("without a name"));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,axis_x,axis_z"),
                HasSubstr("no column \"axis_y\"; expected all columns of a vector"));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,v"),
                HasSubstr("no column \"u\""));
    EXPECT_THAT(tool_path_columns_complaint("tip_x_mm,tip_y_mm,tip_z_mm,tip_x_mm"),
                HasSubstr("two columns named \"tip_x_mm\""));
}

}  // namespace
}  // namespace endmill
