// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep_plan.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/files/path_file.h"
#include "endmill/job/child_process.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class SweepPlanTest : public testing::Test {
protected:
    SweepPlanTest()
    {
        put("part.json", R"({"format": "endmill-job/1", "part": {"file": "part.json"}})");
        put("cases.csv", "scallop,cutter\n0.1,a\n0.2,\n");
    }
    void put(const std::string& name, const std::string& content) const
    {
        std::ofstream{folder.path() / name} << content;
    }
    // The plan of these keys, beside format, command and input.
    SweepPlan plan(const std::string& keys, const std::string& command = "plan") const
    {
        put("plan.json", text(keys, command));
        return read_sweep_plan(folder.path() / "plan.json", some_program());
    }
    static std::string text(const std::string& keys, const std::string& command)
    {
        return R"({"format": "endmill-sweep/1", "input": "part.json", "command": ")" +
               command + "\", " + keys + "}";
    }
    std::string complaint(const std::string& keys,
                          const std::string& command = "plan") const
    {
        return error_of([&] { plan(keys, command); });
    }

    PrivateFolder folder{testing::TempDir()};
};

TEST_F(SweepPlanTest, HasTheArgumentsOfEachCase)
{
    const SweepPlan read = plan(R"("name": "n", "source": "s", "options": {"cutter": "a"},
        "grid": [{"scallop": [1, 2]}], "columns": ["tcd_mm", "u.passes"])");
    EXPECT_EQ(read.name(), "n");
    EXPECT_EQ(read.source(), "s");
    EXPECT_EQ(read.command(), "plan");
    EXPECT_EQ(read.version(), "1.2.3");
    EXPECT_EQ(read.count(), 2);
    EXPECT_THAT(read.parameters(), ElementsAre("scallop"));
    EXPECT_THAT(read.values(1), ElementsAre("2"));
    EXPECT_THAT(read.arguments(1),
                ElementsAre("plan", (folder.path() / "part.json").string(), "--cutter=a",
                            "--scallop=2"));
    EXPECT_EQ(read.columns()[1].file, "summary.json");
    EXPECT_THAT(read.columns()[1].keys, ElementsAre("u", "passes"));
    EXPECT_TRUE(read.gives("cutter"));
    EXPECT_TRUE(read.gives("scallop"));
    EXPECT_FALSE(read.gives("arcs"));
}

TEST_F(SweepPlanTest, LeavesOutTheOptionOfAnEmptyCell)
{
    const SweepPlan read = plan(R"("list": "cases.csv")");
    EXPECT_EQ(read.count(), 2);
    EXPECT_THAT(
        read.arguments(1),
        ElementsAre("plan", (folder.path() / "part.json").string(), "--scallop=0.2"));
}

TEST_F(SweepPlanTest, HashesVersionPlanAndList)
{
    const std::string keys = R"("list": "cases.csv")";
    const std::string before = plan(keys).sha256();
    const std::string zero{"\0", 1};
    EXPECT_EQ(before, content_sha256("1.2.3" + zero + text(keys, "plan") + zero +
                                     "scallop,cutter\n0.1,a\n0.2,\n" + zero));
    put("cases.csv", "scallop,cutter\n0.1,b\n0.2,\n");
    EXPECT_NE(plan(keys).sha256(), before);
}

TEST_F(SweepPlanTest, FindsTheSummariesOfTheStepsOfAJob)
{
    const SweepPlan read = plan(
        R"("grid": [{"plan.scallop": [1]}], "columns": ["plan.tcd_mm", "post.blocks"])",
        "run");
    EXPECT_EQ(read.columns()[0].file, "02-plan/summary.json");
    EXPECT_THAT(read.columns()[0].keys, ElementsAre("tcd_mm"));
    EXPECT_EQ(read.columns()[1].file, "07-post/summary.json");
    EXPECT_THAT(
        complaint(R"("grid": [{"plan.scallop": [1]}], "columns": ["plam.x"])", "run"),
        HasSubstr("did you mean \"plan\""));
    EXPECT_THAT(
        complaint(R"("grid": [{"plan.scallop": [1]}], "columns": ["plan"])", "run"),
        HasSubstr("/columns/0: \"plan\"; expected keys of a summary"));
}

TEST_F(SweepPlanTest, RefusesWhatIsNoPlan)
{
    const std::string grid = R"("grid": [{"scallop": [1]}])";
    EXPECT_EQ(complaint(grid), "accepted");
    EXPECT_THAT(complaint(grid + R"(, "gird": 1)"), HasSubstr("did you mean \"grid\""));
    EXPECT_THAT(complaint(grid, "plam"), HasSubstr("did you mean \"plan\""));
    EXPECT_THAT(
        complaint(R"("name": "x")"),
        HasSubstr("none of the keys grid, list and random; expected exactly one"));
    EXPECT_THAT(complaint(grid + R"(, "list": "cases.csv")"),
                HasSubstr("the keys grid and list; expected exactly one"));
    EXPECT_THAT(complaint(grid + R"(, "options": {"scallop": 1})"),
                HasSubstr("key \"scallop\" has one value for all cases and varies too"));
    EXPECT_THAT(complaint(grid + R"(, "options": {"cuter": 1})"),
                HasSubstr(":/options/cuter: unknown key \"cuter\"; expected"));
    EXPECT_THAT(complaint(grid + R"(, "options": {"input": "part.json"})"),
                HasSubstr(":/options/input: unknown key; expected input outside"));
    EXPECT_THAT(complaint(grid + R"(, "columns": ["scallop"])"),
                HasSubstr("which is the name of another column of results.csv"));
    EXPECT_THAT(complaint(grid + R"(, "columns": ["a", "a"])"),
                HasSubstr("which is the name of another column"));
    EXPECT_THAT(complaint(grid + R"(, "columns": ["a..b"])"),
                HasSubstr("expected keys of a summary with dots between"));
}

TEST_F(SweepPlanTest, RefusesMissingFilesAndCycles)
{
    EXPECT_THAT(complaint(R"("list": "plan.json")"),
                HasSubstr(":/list: \"plan.json\", the plan itself; expected a CSV file"));
    EXPECT_THAT(complaint(R"("list": "nowhere.csv")"), HasSubstr("nowhere.csv"));
    EXPECT_THAT(complaint(R"("grid": [{"input": ["part.json"]}])"),
                HasSubstr("key \"input\" has one value for all cases and varies too"));
    const auto without_input = [&] {
        parse_sweep_plan(
            R"({"format": "endmill-sweep/1", "command": "plan", "grid": [{"scallop": [1]}]})",
            folder.path() / "plan.json", some_program());
    };
    EXPECT_THAT(error_of(without_input), HasSubstr("no input; expected the key input"));
    const auto missing = [&] {
        parse_sweep_plan(R"({"format": "endmill-sweep/1", "command": "plan",
                             "grid": [{"input": ["part.json", "other.json"]}]})",
                         folder.path() / "plan.json", some_program());
    };
    EXPECT_THAT(error_of(missing), HasSubstr(":/grid/0/input/1: found "));
    EXPECT_THAT(error_of(missing), HasSubstr("other.json, which does not exist"));
}

TEST_F(SweepPlanTest, ReadsTheJobOfTheFirstCaseWithEachKey)
{
    const std::string list = R"("list": "late.csv")";
    put("late.csv", "plan.scallop,tolerances.scallop_mm\n1,\n2,0.1\n");
    EXPECT_EQ(complaint(list, "run"), "accepted");
    put("late.csv", "plan.scallop,tolerances.scalop_mm\n1,\n2,0.1\n");
    EXPECT_THAT(complaint(list, "run"),
                HasSubstr("plan.json: case 1: tolerances.scalop_mm: unknown key"));
}

TEST_F(SweepPlanTest, ReadsTheJobsOfAllFiles)
{
    const std::string random = R"("random": {"count": 50, "seed": 1, "parameters": {
        "plan.scallop": {"from": 0, "to": 1}, "part.file": {"one_of": )";
    EXPECT_EQ(complaint(random + R"(["part.json"]}}})", "run"), "accepted");
    EXPECT_THAT(complaint(random + R"(["part.json", "none.json"]}}})", "run"),
                testing::AllOf(HasSubstr("plan.json: case "), HasSubstr(": part.file: "),
                               HasSubstr("none.json, which does not exist")));
    EXPECT_THAT(complaint(R"("grid": [{"material": ["part.json", "none.json"]}])", "run"),
                HasSubstr("plan.json: case 1: material: "));
}

TEST(SweepShard, HasEveryNthCase)
{
    constexpr std::uint64_t cases = 10;
    std::vector<int> seen(cases);
    for (std::uint64_t number = 1; number <= 4; ++number) {
        const SweepShard shard{number, 4};
        for (std::uint64_t i = 0; i < shard.size(cases); ++i)
            ++seen.at(shard.at(i));
    }
    EXPECT_THAT(seen, testing::Each(1));
    EXPECT_EQ((SweepShard{3, 4}.text()), "3/4");
    EXPECT_EQ((SweepShard{7, 8}.size(3)), 0);
}

}  // namespace
}  // namespace endmill
