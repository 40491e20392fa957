// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/files/detail/csv_lines.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "complaint.h"
#include "endmill/files/csv.h"

namespace endmill {
namespace {

using Cells = std::vector<std::string>;

std::vector<Cells> all_cells(const std::string& text)
{
    std::vector<Cells> lines;
    for (CsvLines reader{text, "f"}; reader.next();)
        lines.emplace_back(reader.cells().begin(), reader.cells().end());
    return lines;
}

std::string csv_lines_complaint(const std::string& text)
{
    return complaint_of([&] { all_cells(text); });
}

TEST(CsvLines, CutAtCommasAndLineEnds)
{
    const std::vector<Cells> expected{{"a", "b", ""}, {""}, {"", ""}, {"1", "x y", "-2"}};
    EXPECT_EQ(all_cells("a,b,\n\n,\n1,x y,-2\n"), expected);
    EXPECT_EQ(all_cells("\xef\xbb\xbf"
                        "a,b,\r\n\r\n,\r\n1,x y,-2"),
              expected);
    EXPECT_TRUE(all_cells("").empty());
}

TEST(CsvLines, TakeQuotesOffCells)
{
    const std::vector<Cells> expected{{"a,b", "", "c"}};
    EXPECT_EQ(all_cells("\"a,b\",\"\",c\n"), expected);
    EXPECT_EQ(all_cells("\"a,b\",,\"c\""), expected);
}

// `parse_csv` is an independent reader of the same format.
TEST(CsvLines, CutAsTheGeneralReaderDoes)
{
    const std::string text = "a,\"b\",c\n1,\"2,5\",\"\"\r\n,,\n\"x\",y,z";
    const CsvTable table = parse_csv(text, "f");
    const std::vector<Cells> lines = all_cells(text);
    ASSERT_EQ(lines.size(), table.rows() + 1);
    for (std::size_t row = 0; row < table.rows(); ++row)
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_EQ(lines[row + 1][c], table.cell(row, lines[0][c]));
}

TEST(CsvLines, RefuseQuotesThatDoNotEncloseACellOfOneLine)
{
    EXPECT_EQ(csv_lines_complaint("a\n\"b\nc\"\n"),
              "E_CSV f:2: a quote that is not closed; expected a closing quote");
    for (const char* text : {"a\nb\"c\n", "a\n\"b\"c\n", "a\n\"b\"\"c\"\n", "a\nb,c\"\n"})
        EXPECT_THAT(csv_lines_complaint(text),
                    testing::StartsWith("E_CSV f:2: a quote inside"))
            << text;
    EXPECT_THAT(csv_lines_complaint("a\rb\n"),
                testing::HasSubstr("f:1: a carriage return"));
}

TEST(CsvLines, ReturnTheTextAfterTheLine)
{
    const std::string text = "a\nb\r\nc";
    CsvLines reader{text, "f"};
    EXPECT_EQ(line_count(reader.rest()), 3U);
    reader.next();
    EXPECT_EQ(reader.rest(), "b\r\nc");
    EXPECT_EQ(line_count(reader.rest()), 2U);
    EXPECT_EQ(line_count("b\n"), 1U);
    EXPECT_EQ(line_count(""), 0U);
}

TEST(CsvLines, CountOnFromLinesBefore)
{
    CsvLines reader{"\xef\xbb\xbf,x\n\"", "f", 6};
    reader.next();
    EXPECT_EQ(reader.line(), 7U);
    EXPECT_EQ(reader.cells().front(), "\xef\xbb\xbf");  // a mark only begins a file
    EXPECT_THAT(complaint_of([&] { reader.next(); }), testing::HasSubstr("f:8: "));
}

TEST(CsvRuns, AreWholeLinesThatMakeUpTheText)
{
    for (const bool ends : {false, true}) {
        std::string text;
        for (int i = 0; i < 200000; ++i)
            text += std::to_string(i) + '\n';
        if (!ends)
            text.pop_back();
        std::string joined;
        std::size_t line = 0;
        const std::vector<CsvRun> runs = csv_runs(text);
        for (const CsvRun& run : runs) {
            EXPECT_EQ(run.first_line, line);
            EXPECT_EQ(run.text.substr(0, run.text.find('\n')), std::to_string(line));
            line += line_count(run.text);
            joined += run.text;
        }
        EXPECT_GT(runs.size(), 2U);
        EXPECT_EQ(joined, text);
        EXPECT_EQ(line, 200000U);
    }
    EXPECT_TRUE(csv_runs("").empty());
    EXPECT_EQ(csv_runs("a").size(), 1U);
}

}  // namespace
}  // namespace endmill
