// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/step_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"
#include "job_program.h"

namespace endmill {
namespace {

using testing::ElementsAre;

class StepRuns : public testing::Test {
protected:
    StepEnd end_of(JobStep step, const std::string& script)
    {
        StepRun run{.step = step,
                    .program = job_program(folder_.path(), script).program,
                    .arguments = {"input"},
                    .folder = folder_.path() / "out"};
        run.progress = [&](const WorkProgress& work) { progress_.push_back(work); };
        run.warning = [&](const std::string& text) { warnings_.push_back(text); };
        return run_step(run);
    }

    PrivateFolder folder_{testing::TempDir()};
    std::vector<WorkProgress> progress_;
    std::vector<std::string> warnings_;
};

TEST_F(StepRuns, GivesTheCommandItsInputAndItsFolder)
{
    EXPECT_EQ(end_of(JobStep::Clamp, "").exit, 0);
    EXPECT_EQ(content_of(folder_.path() / "calls.txt"),
              "setup input --output=" + (folder_.path() / "out").string() +
                  " --json --json-errors --json-progress\n");
}

TEST_F(StepRuns, SortsTheLinesOfTheCommand)
{
    const StepEnd end = end_of(JobStep::Plan, R"(exec >&2
echo 'endmill: warning: thin'
echo '{"progress": {"work": "planning", "share": 0.25, "left_s": 3}}'
echo '{"progress": {"work": 7, "share": "x", "left_s": null}}'
echo '{"error": {"code": "E_JSON", "message": "found 1; expected 2"}}'
exit 3)");
    EXPECT_EQ(end.exit, 3);
    EXPECT_FALSE(end.is_no);
    EXPECT_EQ(end.code, "E_JSON");
    EXPECT_EQ(end.reason, "found 1; expected 2");
    EXPECT_THAT(end.warnings, ElementsAre("thin"));
    EXPECT_EQ(warnings_, end.warnings);
    ASSERT_EQ(progress_.size(), 2);
    EXPECT_EQ(progress_[0].work, "planning");
    EXPECT_EQ(progress_[0].share, 0.25);
    EXPECT_EQ(progress_[0].left_s, 3);
    EXPECT_EQ(progress_[1].work, "");
    EXPECT_FALSE(progress_[1].share);
}

TEST_F(StepRuns, NamesTheLastLineOfACommandWithoutAMessage)
{
    const StepEnd end =
        end_of(JobStep::Post, "echo first >&2; printf 'a\\033last' >&2; kill -ABRT $$");
    EXPECT_EQ(end.exit, 128 + 6);
    EXPECT_EQ(end.reason, "the command was ended by signal 6: alast");
    EXPECT_EQ(end_of(JobStep::Post, "exit 9").reason,
              "the command ended with exit code 9");
}

TEST_F(StepRuns, StatesTheVerdictOfAPathThatIsNotClean)
{
    const StepEnd end = end_of(
        JobStep::Verify,
        R"(echo '{"verdict": "gouged", "max_gouge_mm": 0.03125}' > "$out/summary.json"; exit 1)");
    EXPECT_TRUE(end.is_no);
    EXPECT_EQ(end.reason, "the path is not clean: gouged, gouge up to 0.03125 mm");
    EXPECT_THROW(end_of(JobStep::Verify, R"(rm "$out/summary.json"; exit 1)"),
                 FormatError);
}

TEST_F(StepRuns, ReportsAProgramThatIsMissing)
{
    const StepEnd end = run_step({.step = JobStep::Plan,
                                  .program = folder_.path() / "none",
                                  .folder = folder_.path()});
    EXPECT_EQ(end.exit, 7);
}

TEST(Advice, IsGivenForEachStep)
{
    for (std::size_t i = 0; i < job_step_count; ++i)
        EXPECT_NE(advice_for(static_cast<JobStep>(i)), "");
}

}  // namespace
}  // namespace endmill
