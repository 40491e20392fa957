// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/job_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"

namespace endmill {
namespace {

JobRecord example()
{
    JobRecord record{"saddle", "1.0", true, 1};
    record.steps.at(0) = {.state = StepState::NotNeeded, .reason = "three axes"};
    record.steps.at(1) = {.state = StepState::Failed,
                          .reason = "gouged",
                          .exit = 1,
                          .wall_s = 0.25,
                          .command = {"plan", "a \"b\".json"},
                          .inputs = {{"../a.json", "00ff"}},
                          .sha256 = "12",
                          .results_sha256 = "34",
                          .warnings = {"thin"}};
    return record;
}

TEST(JobRecord, ReadsBackWhatItWrote)
{
    const std::string text = job_record_text(example());
    const auto read = parse_job_record(text);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->name, "saddle");
    EXPECT_TRUE(read->is_finished);
    const StepRecord& step = read->steps.at(1);
    EXPECT_EQ(step.state, StepState::Failed);
    EXPECT_EQ(step.wall_s, 0.25);
    EXPECT_EQ(step.command, example().steps.at(1).command);
    EXPECT_EQ(step.inputs.at(0).sha256, "00ff");
    JobRecord again = *read;
    again.exit = 1;
    EXPECT_EQ(job_record_text(again), text);
}

TEST(JobRecord, IsNothingIfItIsBroken)
{
    std::string text = job_record_text(example());
    for (std::size_t length = 0; length + 2 < text.size(); length += 7)
        EXPECT_FALSE(parse_job_record(text.substr(0, length))) << length;
    EXPECT_FALSE(parse_job_record(R"({"format": "endmill-job-state/2"})"));
    text.replace(text.find("\"failed\""), 8, "\"broken\"");
    EXPECT_FALSE(parse_job_record(text));
    const PrivateFolder folder{testing::TempDir()};
    EXPECT_FALSE(read_job_record(folder.path()));
}

TEST(StepSha256, DependsOnAllThatTheStepDependsOn)
{
    const std::string hash = step_sha256("1", {"plan", "a"}, {{"a", "0"}});
    EXPECT_EQ(hash.size(), 64);
    EXPECT_EQ(step_sha256("1", {"plan", "a"}, {{"a", "0"}}), hash);
    EXPECT_NE(step_sha256("2", {"plan", "a"}, {{"a", "0"}}), hash);
    EXPECT_NE(step_sha256("1", {"plana"}, {{"a", "0"}}), hash);
    EXPECT_NE(step_sha256("1", {"plan", "a"}, {{"a", "1"}}), hash);
}

}  // namespace
}  // namespace endmill
