// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/sweep_results.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/files/csv.h"
#include "endmill/job/child_process.h"
#include "some_program.h"

namespace endmill {
namespace {

TEST(CsvLine, ReadsBackToItsCells)
{
    const std::vector<std::string> header{"a", "b", "c", "d"};
    const std::vector<std::string> cells{"x", "", "1,2", "say \"so\""};
    const CsvTable table = parse_csv(csv_line(header) + csv_line(cells), "f");
    for (std::size_t i = 0; i < header.size(); ++i)
        EXPECT_EQ(table.cell(0, header[i]), cells[i]);
    EXPECT_EQ(csv_line(cells), "x,,\"1,2\",\"say \"\"so\"\"\"\n");
}

TEST(SweepFacts, AreReadAsTheyWereWritten)
{
    const PrivateFolder folder{testing::TempDir()};
    EXPECT_FALSE(read_sweep_facts(folder.path()));
    const SweepFacts facts{{"abc", 10, {2, 3}}, "1.0", "n", "s", "plan", 4, 2.5};
    write_results(folder.path() / "x", FullFolder::Refuse, facts,
                  [](const OutputFolder::Sink& sink) { sink("case\n"); });
    const auto read = read_sweep_facts(folder.path() / "x");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->identity, facts.identity);
    EXPECT_EQ(sweep_text(*read), sweep_text(facts));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "x/results.csv"));
}

TEST(SweepFacts, OfAnotherFormatAreRefused)
{
    const PrivateFolder folder{testing::TempDir()};
    std::ofstream{folder.path() / sweep_file} << R"({"format": "endmill-tool/1"})";
    EXPECT_THAT(error_of([&] { read_sweep_facts(folder.path()); }),
                testing::HasSubstr("endmill-sweep-results/1"));
}

}  // namespace
}  // namespace endmill
