// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/program_options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

using testing::ElementsAre;

const ProgramOption cutter{"--cutter", OptionValue::Text};
const ProgramOption arcs{"--arcs", OptionValue::None};
const ProgramOption tool{"--tool-file", OptionValue::File};
const ProgramOption machine{"--machine", OptionValue::FileOrWord};

TEST(ProgramOption, HasAKeyWithoutHyphens)
{
    EXPECT_EQ(tool.key(), "tool_file");
}

TEST(GivenOption, WithAValueIsOneArgument)
{
    const std::vector<GivenOption> given{*given_option(cutter, "ball:10", "."),
                                         *given_option(arcs, "true", ".")};
    EXPECT_THAT(arguments_of(given), ElementsAre("--cutter=ball:10", "--arcs"));
}

TEST(GivenOption, WithoutAValueIsTrueOrFalse)
{
    EXPECT_FALSE(given_option(arcs, "false", "."));
    EXPECT_THROW(given_option(arcs, "1", "."), DomainError);
}

TEST(GivenOption, FindsAFileBesideTheBase)
{
    const PrivateFolder folder{testing::TempDir()};
    folder.write("tool.json", "{}");
    const auto given = given_option(tool, "./tool.json", folder.path());
    EXPECT_TRUE(given->is_file);
    EXPECT_EQ(given->value, (folder.path() / "tool.json").string());
    EXPECT_THROW(given_option(tool, "other.json", folder.path()), DomainError);
    EXPECT_FALSE(given_option(tool, "none", folder.path())->is_file);
}

TEST(GivenOption, TakesAWordWhereAFileIsNotNeeded)
{
    const auto given = given_option(machine, "W/xyBz/T", ".");
    EXPECT_FALSE(given->is_file);
    EXPECT_EQ(given->value, "W/xyBz/T");
}

TEST(AddDefault, DoesNotReplace)
{
    std::vector<GivenOption> given{{"--cutter", "ball:10"}};
    add_default(given, {"--cutter", "ball:6"});
    add_default(given, {"--scallop", "0.1"});
    EXPECT_THAT(arguments_of(given), ElementsAre("--cutter=ball:10", "--scallop=0.1"));
    EXPECT_TRUE(is_given(given, "--scallop"));
    EXPECT_FALSE(is_given(given, "--planes"));
}

TEST(ProgramCommand, FindsAnOptionByItsKey)
{
    const ProgramCommand command{"plan", {cutter, tool}};
    EXPECT_EQ(command.find("tool_file")->name, "--tool-file");
    EXPECT_EQ(command.find("tool-file"), nullptr);
    EXPECT_THAT(command.keys(), ElementsAre("cutter", "tool_file"));
}

TEST(ProgramDescription, FindsACommandByItsName)
{
    const ProgramDescription program{"/bin/true", "1", {{"plan", {cutter}}}};
    EXPECT_EQ(program.find("plan")->options.size(), 1);
    EXPECT_EQ(program.find("mill"), nullptr);
}

}  // namespace
}  // namespace endmill
