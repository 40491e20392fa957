// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/job_steps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/job/child_process.h"
#include "job_program.h"

namespace endmill {
namespace {

using testing::Contains;
using testing::Not;

class JobSteps : public testing::Test {
protected:
    JobSteps() : folder_{testing::TempDir()}
    {
        folder_.write("part.json", "{}");
        state_.folder = folder_.path() / "out";
    }

    std::variant<StepCommand, StepNotNeeded> choice(const std::string& keys, JobStep step)
    {
        return step_command(
            parse_job(R"({"format": "endmill-job/1", "part": {"file": "part.json"}, )" +
                          keys + "}",
                      folder_.path() / "job.json", job_program(folder_.path())),
            step, state_);
    }

    std::vector<std::string> arguments(const std::string& keys, JobStep step)
    {
        return arguments_of(std::get<StepCommand>(choice(keys, step)).options);
    }

    void do_step(JobStep step, const std::string& file)
    {
        state_.is_done.at(static_cast<std::size_t>(step)) = true;
        put(state_.folder / job_step_folder(step) / file, "path");
    }

    PrivateFolder folder_;
    ChainState state_;
};

TEST(JobStepFolder, HasTheNumberOfTheStep)
{
    EXPECT_EQ(job_step_folder(JobStep::Setup), "01-setup");
    EXPECT_EQ(job_step_folder(JobStep::Post), "07-post");
}

TEST_F(JobSteps, AnOptionOfTheStepPrecedesThatOfTheJob)
{
    const auto given =
        arguments(R"("tool": "ball:10", "plan": {"cutter": "ball:4"})", JobStep::Plan);
    EXPECT_THAT(given, Contains("--cutter=ball:4"));
    EXPECT_THAT(given, Not(Contains("--cutter=ball:10")));
}

TEST_F(JobSteps, PlansAsThePartStands)
{
    do_step(JobStep::Setup, "summary.json");
    const std::string summary = (state_.folder / "01-setup/summary.json").string();
    EXPECT_THAT(arguments(R"("machine": "W/caxyBz/T")", JobStep::Plan),
                Contains("--setup=" + summary));
    EXPECT_THAT(arguments(R"("machine": "W/caxyBz/T", "setup": {"max_setups": 4})",
                          JobStep::Plan),
                Contains("--setups=" + summary));
}

TEST_F(JobSteps, ClampsThePathOfSeveralSetups)
{
    do_step(JobStep::Plan, "toolpath.csv");
    EXPECT_TRUE(std::holds_alternative<StepNotNeeded>(
        choice(R"("machine": "W/caxyBz/T")", JobStep::Clamp)));
    EXPECT_TRUE(std::holds_alternative<StepCommand>(choice(
        R"("machine": "W/caxyBz/T", "setup": {"max_setups": 4})", JobStep::Clamp)));
}

TEST_F(JobSteps, FollowsTheRecommendedDirection)
{
    do_step(JobStep::Plan, "u/toolpath.csv");
    put(state_.folder / "02-plan/summary.json", R"({"recommended": "v"})");
    EXPECT_EQ(std::get<StepCommand>(choice(R"("name": "x")", JobStep::Verify)).input,
              state_.folder / "02-plan/v/toolpath.csv");
}

TEST_F(JobSteps, PostsThePathWithFeeds)
{
    do_step(JobStep::Plan, "toolpath.csv");
    EXPECT_THAT(arguments(R"("feed_mm_per_min": 800)", JobStep::Post),
                Contains("--feed=800"));
    do_step(JobStep::Feed, "toolpath.csv");
    EXPECT_EQ(std::get<StepCommand>(choice(R"("name": "x")", JobStep::Post)).input,
              state_.folder / "04-feed/toolpath.csv");
    EXPECT_THAT(arguments(R"("feed_mm_per_min": 800)", JobStep::Post),
                Not(Contains("--feed=800")));
}

TEST_F(JobSteps, LeavesOutWhatTheJobDoesNotWant)
{
    EXPECT_TRUE(
        std::holds_alternative<StepNotNeeded>(choice(R"("plan": false)", JobStep::Plan)));
}

}  // namespace
}  // namespace endmill
