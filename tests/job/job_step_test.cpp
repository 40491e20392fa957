// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/job_step.h"

#include <gtest/gtest.h>

namespace endmill {
namespace {

TEST(JobStep, HasANameAndACommand)
{
    EXPECT_EQ(job_step_name(JobStep::Setup), "setup");
    EXPECT_EQ(job_step_name(JobStep::Post), "post");
    EXPECT_EQ(job_step_command(JobStep::Post), "post");
    EXPECT_EQ(job_step_command(JobStep::Clamp), "setup");
}

TEST(StepState, HasAWord)
{
    EXPECT_EQ(word_of(StepState::Done), "done");
    EXPECT_EQ(word_of(StepState::UpToDate), "up to date");
    EXPECT_EQ(word_of(StepState::WouldRun), "would run");
}

}  // namespace
}  // namespace endmill
