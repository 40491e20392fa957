// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/csv.h"

#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "temporary_folder.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(CsvTable, SpellsEachKindOfCell)
{
    CsvTable table{{"name", "count", "length_mm", "share"}};
    table.add_row({"plain", std::int64_t{-7}, 0.1, std::monostate{}});
    table.add_row({"", std::int64_t{9007199254740993}, -1e-300, 1.0});
    EXPECT_EQ(table.text(),
              "name,count,length_mm,share\n"
              "plain,-7,0.1,\n"
              ",9007199254740993,-1e-300,1\n");
}

// The examples of RFC 4180, section 2.
TEST(CsvTable, QuotesAsRfc4180Does)
{
    CsvTable table{{"a", "b"}};
    table.add_row({"b\"bb", "x,y"});
    table.add_row({"two\r\nlines", "plain text"});
    EXPECT_EQ(table.text(), "a,b\n\"b\"\"bb\",\"x,y\"\n\"two\r\nlines\",plain text\n");
}

TEST(CsvTable, EscapesFormulasInTextOnly)
{
    CsvTable table{{"text", "number"}};
    for (const char* formula : {"=1+1", "+1", "-1", "@SUM(A1)", "\tx"})
        table.add_row({formula, -1.5});
    for (std::size_t row = 0; row < table.rows(); ++row) {
        EXPECT_EQ(table.cell(row, "text").front(), '\'');
        EXPECT_EQ(table.cell(row, "number"), "-1.5");
    }
}

TEST(CsvTable, RefusesInvalidCellsAndNames)
{
    CsvTable table{{"a", "b"}};
    EXPECT_THROW(table.add_row({1.0}), DomainError);
    EXPECT_THROW(table.add_row({1.0, std::numeric_limits<double>::quiet_NaN()}),
                 DomainError);
    EXPECT_THROW(table.add_row({std::numeric_limits<double>::infinity(), 1.0}),
                 DomainError);
    EXPECT_EQ(table.rows(), 0U);
    EXPECT_THROW(CsvTable{{}}, DomainError);
    EXPECT_THROW((CsvTable{{"a", "a"}}), DomainError);
    EXPECT_THROW((CsvTable{{"a", ""}}), DomainError);
}

TEST(CsvTable, NumbersReadBackAsTheSameDoubles)
{
    std::mt19937_64 random{7};
    std::vector<double> values;
    CsvTable table{{"x"}};
    while (values.size() < 1000) {
        const auto value = std::bit_cast<double>(random());
        if (!std::isfinite(value))
            continue;
        values.push_back(value);
        table.add_row({value});
    }
    const CsvTable read = parse_csv(table.text(), "f");
    for (std::size_t row = 0; row < values.size(); ++row)
        EXPECT_EQ(read.number(row, "x"), values[row]);
}

TEST(ParseCsv, ReadsQuotesLineEndsAndAByteOrderMark)
{
    const CsvTable table = parse_csv(
        "\xef\xbb\xbf"
        "a,b\r\n\"x,\"\"y\"\"\",\"1\n2\"\r\n,3",
        "f");
    EXPECT_THAT(table.columns(), ElementsAre("a", "b"));
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.cell(0, "a"), "x,\"y\"");
    EXPECT_EQ(table.cell(0, "b"), "1\n2");
    EXPECT_EQ(table.cell(1, "a"), "");
    EXPECT_EQ(table.number(1, "a"), std::nullopt);
    EXPECT_EQ(table.number(1, "b"), 3);
}

TEST(ParseCsv, GivesBackTheTextOfATableThatWasRead)
{
    for (const std::string text : {"a\n\"\"\n1\n", "a,b\n'=x,\"p,q\"\n,\n"})
        EXPECT_EQ(parse_csv(text, "f").text(), text);
}

std::string csv_complaint(const std::string& text)
{
    try {
        const CsvTable table = parse_csv(text, "f");
        for (std::size_t row = 0; row < table.rows(); ++row)
            table.number(row, table.columns().back());
        return "accepted";
    } catch (const FormatError& error) {
        EXPECT_EQ(error.code(), "E_CSV");
        return error.what();
    }
}

TEST(ParseCsv, StatesTheLineOfAnError)
{
    EXPECT_EQ(csv_complaint("a,b\n1,2\n3\n"), "f:3: row has 1 cells; expected 2");
    EXPECT_EQ(csv_complaint("a,b\n1,2,3\n"), "f:2: row has 3 cells; expected 2");
    EXPECT_THAT(csv_complaint("a,b\n\"1\n\n2\",2\n3\n"), testing::StartsWith("f:5: "));
    EXPECT_THAT(csv_complaint("a,b\n1,2\n\"3,4\n5,6\n"),
                testing::StartsWith("f:3: a quote that is never closed"));
    EXPECT_THAT(csv_complaint("a\nx\"y\n"), testing::StartsWith("f:2: a quote inside"));
    EXPECT_THAT(csv_complaint("a\n\"x\"y\n"), testing::StartsWith("f:2: "));
    EXPECT_THAT(csv_complaint("a\rb\n"), testing::StartsWith("f:1: a carriage return"));
    EXPECT_THAT(csv_complaint("a,,b\n"), testing::StartsWith("f:1: a column without"));
    EXPECT_THAT(csv_complaint("a,a\n"), testing::StartsWith("f:1: two columns named"));
    EXPECT_THAT(csv_complaint("a,b\nx,1\ny,1;5\n"),
                testing::StartsWith("f:3: b is \"1;5\"; expected a number"));
    EXPECT_THAT(csv_complaint("a\nnan\n"), HasSubstr("expected a number"));
}

TEST(ParseCsv, StatesWhichColumnIsMissing)
{
    try {
        static_cast<void>(parse_csv("a\n1\n", "f").number(0, "b"));
        FAIL();
    } catch (const FormatError& error) {
        EXPECT_STREQ(error.what(),
                     "f:1: no column \"b\"; expected a column of this name");
    }
}

TEST(ReadCsv, ReadsAFileWithinTheMemoryLimit)
{
    const TemporaryFolder folder;
    const auto path = folder.put("a.csv", "x\n1\n");
    EXPECT_EQ(read_csv(path).number(0, "x"), 1);
    EXPECT_THAT([&] { read_csv(path, {.max_memory_gib = 1e-8}); },
                testing::ThrowsMessage<LimitError>(HasSubstr("a.csv: reading it needs")));
}

}  // namespace
}  // namespace endmill
