// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/job_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"
#include "job_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class JobFile : public testing::Test {
protected:
    JobFile() : folder_{testing::TempDir()}
    {
        folder_.write("part.json", "{}");
        folder_.write("tool.json",
                      R"({"format": "endmill-tool/1", "cutter": "bull:10:2"})");
    }

    // A job with these keys beside the format and the part.
    Job job(const std::string& keys, const std::vector<JobSetting>& settings = {}) const
    {
        return parse_job(R"({"format": "endmill-job/1", "part": {"file": "part.json"})" +
                             (keys.empty() ? "" : ", " + keys) + "}",
                         folder_.path() / "job.json", program_, settings);
    }

    std::string refusal(const std::string& keys,
                        const std::vector<JobSetting>& settings = {}) const
    {
        try {
            job(keys, settings);
            return "accepted";
        } catch (const Error& error) {
            return error.what();
        }
    }

    PrivateFolder folder_;
    ProgramDescription program_ = job_program(folder_.path());
};

TEST_F(JobFile, NeedsOnlyAPart)
{
    const Job read = job("");
    EXPECT_EQ(read.name, "job");
    EXPECT_EQ(read.part, folder_.path() / "part.json");
    EXPECT_EQ(read.rotary_axes, 0);
    for (const StepRequest& step : read.steps)
        EXPECT_EQ(step.wish, StepWish::Default);
}

TEST_F(JobFile, TakesTheCutterFromTheToolFile)
{
    EXPECT_EQ(job(R"("tool": "tool.json")").cutter->value, "bull:10:2");
    EXPECT_EQ(job(R"("tool": "ball:6")").cutter->value, "ball:6");
    EXPECT_FALSE(job(R"("tool": "ball:6")").tool);
}

TEST_F(JobFile, CountsTheRotaryAxesOfTheMachine)
{
    EXPECT_EQ(job(R"("machine": "W/xyBz/T")").rotary_axes, 0);
    EXPECT_EQ(job(R"("machine": "W/caxyBz/T")").rotary_axes, 2);
}

TEST_F(JobFile, ReadsTheOptionsOfASteps)
{
    const Job read = job(
        R"("plan": {"scallop": 0.1}, "trim": true, "verify": false, "post": {"arcs": true})");
    EXPECT_EQ(read.request(JobStep::Plan).wish, StepWish::Yes);
    EXPECT_THAT(arguments_of(read.request(JobStep::Plan).options),
                ElementsAre("--scallop=0.1"));
    EXPECT_EQ(read.request(JobStep::Trim).wish, StepWish::Yes);
    EXPECT_EQ(read.request(JobStep::Verify).wish, StepWish::No);
    EXPECT_THAT(arguments_of(read.request(JobStep::Post).options), ElementsAre("--arcs"));
}

TEST_F(JobFile, ReadsTheStepsWhoseNoIsAccepted)
{
    EXPECT_TRUE(job(R"("accept_no": ["verify"])").request(JobStep::Verify).accepts_no);
}

TEST_F(JobFile, RefusesWhatItDoesNotKnow)
{
    EXPECT_THAT(refusal(R"("mashine": "W/xyBz/T")"),
                HasSubstr("did you mean \"machine\""));
    EXPECT_THAT(refusal(R"("plan": {"scalop": 1})"),
                HasSubstr("did you mean \"scallop\""));
    EXPECT_THAT(refusal(R"("plan": 1)"),
                HasSubstr("/plan: 1; expected true, false or an object"));
    EXPECT_THAT(refusal(R"("post": {"arcs": 1})"),
                HasSubstr("/post/arcs: 1; expected true or false"));
    EXPECT_THAT(refusal(R"("accept_no": ["mill"])"), HasSubstr("/accept_no/0"));
    EXPECT_THAT(refusal(R"("machine": "W/xyz/T")"), HasSubstr("B, the bed, is missing"));
    EXPECT_THAT(refusal(R"("tool": "ball")"), HasSubstr("no cutter word"));
    EXPECT_THAT(refusal(R"("material": "none.json")"),
                HasSubstr("which does not exist; expected a file"));
    EXPECT_THAT(refusal(R"("tolerances": {"chord": 1})"), HasSubstr("chord_mm"));
}

TEST_F(JobFile, RefusesAnotherFormat)
{
    const auto parse = [&](const std::string& text) {
        return parse_job(text, "job.json", program_);
    };
    EXPECT_THROW(parse(R"({"format": "endmill-tool/1"})"), FormatError);
    EXPECT_THROW(parse(R"({"format": "endmill-job/2", "part": {}})"), FormatError);
    EXPECT_THROW(parse("solid"), FormatError);
}

TEST_F(JobFile, ASettingReplacesAValue)
{
    const Job read =
        job(R"("plan": {"scallop": 0.1}, "post": true)",
            {{"plan.scallop", "0.2"}, {"post.arcs", "true"}, {"tool", "ball:4"}});
    EXPECT_THAT(arguments_of(read.request(JobStep::Plan).options),
                ElementsAre("--scallop=0.2"));
    EXPECT_THAT(arguments_of(read.request(JobStep::Post).options), ElementsAre("--arcs"));
    EXPECT_EQ(read.cutter->value, "ball:4");
}

TEST_F(JobFile, ASettingIsReadAsStrictly)
{
    EXPECT_THAT(refusal("", {{"plan.scalop", "0.2"}}), HasSubstr("scallop"));
    EXPECT_THAT(refusal("", {{"part.file.x", "0.2"}}), HasSubstr("no such key"));
    EXPECT_THAT(refusal("", {{"plan..x", "0.2"}}), HasSubstr("no such key"));
}

TEST(JobSetting, IsAKeyAndAValue)
{
    const JobSetting setting = job_setting("plan.axis=0,0,1");
    EXPECT_EQ(setting.key, "plan.axis");
    EXPECT_EQ(setting.value, "0,0,1");
    EXPECT_THROW(job_setting("plan"), DomainError);
    EXPECT_THROW(job_setting("=1"), DomainError);
}

}  // namespace
}  // namespace endmill
