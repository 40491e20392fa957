// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_command.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "some_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

// A plan file in a folder with a part.
class CaseCommandTest : public testing::Test {
protected:
    CaseCommandTest()
    {
        std::ofstream{plan} << "{}";
        std::ofstream{folder.path() / "part.json"} << "{}";
    }
    CaseCommand command(std::string_view name) const
    {
        return {some_program(), name, plan};
    }
    std::string complaint(std::string_view name, const KeyValue& given) const
    {
        return error_of([&] {
            command(name).require_key(given.key);
            command(name).require_value(given);
        });
    }

    PrivateFolder folder{testing::TempDir()};
    fs::path plan = folder.path() / "plan.json";
};

TEST_F(CaseCommandTest, SweepsMayRunEveryCommandAndJobs)
{
    EXPECT_THAT(sweep_commands(some_program()), ElementsAre("plan", "numbers", "run"));
}

TEST_F(CaseCommandTest, MakesTheWordsOfACommand)
{
    EXPECT_THAT(command("plan").arguments(std::vector<KeyValue>{{"scallop", "0.1"},
                                                                {"input", "part.json"},
                                                                {"arcs", "true"},
                                                                {"cutter", "a b; $(c)"}}),
                ElementsAre("plan", (folder.path() / "part.json").string(),
                            "--scallop=0.1", "--arcs", "--cutter=a b; $(c)"));
    EXPECT_THAT(command("plan").arguments(std::vector<KeyValue>{{"arcs", "false"}}),
                ElementsAre("plan"));
}

TEST_F(CaseCommandTest, MakesTheWordsOfAJob)
{
    EXPECT_THAT(command("run").arguments(std::vector<KeyValue>{{"input", "part.json"},
                                                               {"plan.scallop", "0.1"}}),
                ElementsAre("run", (folder.path() / "part.json").string(),
                            "--set=plan.scallop=0.1"));
}

TEST_F(CaseCommandTest, RefusesAnUnknownKeyWithASuggestion)
{
    EXPECT_THAT(complaint("plan", {"scalop", "1"}),
                HasSubstr("unknown key \"scalop\"; expected"));
    EXPECT_THAT(complaint("plan", {"scalop", "1"}),
                HasSubstr("did you mean \"scallop\""));
    EXPECT_THAT(complaint("numbers", {"input", "part.json"}), HasSubstr("unknown key"));
    EXPECT_THAT(complaint("run", {"plan.scalop", "1"}),
                HasSubstr("did you mean \"scallop\""));
    EXPECT_THAT(complaint("run", {"a=b", "1"}), HasSubstr("expected a key of a job"));
    EXPECT_EQ(complaint("run", {"part.file", "x"}), "accepted");
}

TEST_F(CaseCommandTest, RefusesAMissingFileAndThePlanItself)
{
    EXPECT_THAT(complaint("plan", {"input", "nowhere.json"}),
                HasSubstr("nowhere.json, which does not exist; expected a file"));
    EXPECT_THAT(complaint("plan", {"input", "plan.json"}),
                HasSubstr("plan.json, the plan itself; expected another file"));
    EXPECT_THAT(complaint("run", {"input", "plan.json"}), HasSubstr("the plan itself"));
    EXPECT_THAT(complaint("plan", {"tool_file", "plan.json"}),
                HasSubstr("the plan itself"));
    EXPECT_EQ(complaint("plan", {"tool_file", "part.json"}), "accepted");
    EXPECT_EQ(complaint("plan", {"tool_file", "none"}), "accepted");
    EXPECT_THAT(complaint("plan", {"arcs", "yes"}), HasSubstr("expected true or false"));
}

TEST_F(CaseCommandTest, KnowsTheKeysThatNameFiles)
{
    for (const std::string key : {"input", "tool_file"})
        EXPECT_TRUE(command("plan").names_files(key)) << key;
    EXPECT_FALSE(command("plan").names_files("scallop"));
    for (const std::string key :
         {"input", "part.file", "machine", "tool", "plan.tool_file"})
        EXPECT_TRUE(command("run").names_files(key)) << key;
    for (const std::string key : {"plan.scallop", "plan", "feed_mm_per_min", "part.up"})
        EXPECT_FALSE(command("run").names_files(key)) << key;
}

TEST_F(CaseCommandTest, ChecksValuesOfFilesAndOfOptionsWithoutOne)
{
    const CaseCommand plan_command = command("plan");
    EXPECT_TRUE(plan_command.checks_values("input"));
    EXPECT_TRUE(plan_command.checks_values("arcs"));
    EXPECT_TRUE(plan_command.checks_values("tool_file"));
    EXPECT_FALSE(plan_command.checks_values("scallop"));
}

}  // namespace
}  // namespace endmill
