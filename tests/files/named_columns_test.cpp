// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/named_columns.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"

namespace endmill {
namespace {

using testing::HasSubstr;

constexpr std::array<std::string_view, 3> names{"s_mm", "z_mm", "curve"};

CsvLines at_header(const std::string& text)
{
    CsvLines lines{text, "f"};
    lines.next();
    return lines;
}

std::string named_columns_complaint(const std::string& text)
{
    return complaint_of([&] {
        CsvLines lines = at_header(text);
        const NamedColumns columns{lines, names, 2};
        while (lines.next())
            columns.check_row(lines);
    });
}

TEST(NamedColumns, StandInAnyOrder)
{
    const std::string text = "curve,z_mm,s_mm\n1,2,3\n";
    CsvLines lines = at_header(text);
    const NamedColumns columns{lines, names, 2};
    ASSERT_TRUE(lines.next());
    columns.check_row(lines);
    EXPECT_TRUE(columns.has(2));
    EXPECT_EQ(columns.cell(lines, 0), "3");
    EXPECT_EQ(columns.cell(lines, 1), "2");
    EXPECT_EQ(columns.cell(lines, 2), "1");
    EXPECT_STREQ(columns.complaint(lines, 1, "more").what(),
                 "f:2: z_mm is \"2\"; expected more");
}

TEST(NamedColumns, MayLackThoseThatAreNotNeeded)
{
    const std::string text = "z_mm,s_mm\n2,3\n";
    CsvLines lines = at_header(text);
    EXPECT_FALSE((NamedColumns{lines, names, 2}.has(2)));
}

TEST(NamedColumns, ReportErrorsOfHeadersAndRows)
{
    EXPECT_THAT(named_columns_complaint("s_mm,zmm\n"),
                HasSubstr("f:1: unknown column \"zmm\""));
    EXPECT_THAT(named_columns_complaint("s_mm,zmm\n"),
                HasSubstr("did you mean \"z_mm\"?"));
    EXPECT_THAT(named_columns_complaint("s_mm,s_mm\n"), HasSubstr("column s_mm twice"));
    EXPECT_THAT(named_columns_complaint("s_mm,curve\n"),
                HasSubstr("no column z_mm; expected s_mm and z_mm"));
    EXPECT_THAT(named_columns_complaint("s_mm,z_mm\n1,2\n1\n"),
                HasSubstr("f:3: row has 1 cell; expected 2"));
}

}  // namespace
}  // namespace endmill
