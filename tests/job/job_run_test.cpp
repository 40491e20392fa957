// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/job_run.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "endmill/core/error.h"
#include "endmill/job/child_process.h"
#include "job_program.h"

namespace endmill {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;
namespace fs = std::filesystem;

class JobRuns : public testing::Test {
protected:
    JobRuns() : folder_{testing::TempDir()} { folder_.write("part.json", "{}"); }

    JobRun run(const std::string& keys, const JobRunOptions& asked = {},
               const std::string& script = "")
    {
        fs::remove(folder_.path() / "calls.txt");
        const ProgramDescription program = job_program(folder_.path(), script);
        const Job job = parse_job(
            R"({"format": "endmill-job/1", "feed_mm_per_min": 800, "part": {"file": "part.json"})" +
                (keys.empty() ? "" : ", " + keys) + "}",
            folder_.path() / "job-file.json", program);
        JobRunOptions options = asked;
        options.folder = folder_.path() / "out";
        options.warning = [this](const std::string& text) { warnings_.push_back(text); };
        return run_job(job, program, options);
    }

    // The first words of the calls of the last run.
    std::vector<std::string> calls() const
    {
        std::vector<std::string> words;
        std::ifstream stream{folder_.path() / "calls.txt"};
        for (std::string line; std::getline(stream, line);)
            words.push_back(line.substr(0, line.find(' ')));
        return words;
    }

    fs::path out() const { return folder_.path() / "out"; }

    PrivateFolder folder_;
    std::vector<std::string> warnings_;
};

StepState state_of(const JobRun& run, JobStep step)
{
    return run.steps.at(static_cast<std::size_t>(step)).state;
}

TEST_F(JobRuns, RunsWhatTheJobNeeds)
{
    EXPECT_EQ(run("").exit, 0);
    EXPECT_THAT(calls(), ElementsAre("plan", "verify", "post"));
    run(R"("machine": "W/caxyBz/T")");  // the path is the same: its verdict holds
    EXPECT_THAT(calls(), ElementsAre("setup", "plan", "post"));
}

TEST_F(JobRuns, RepeatsNothingThatHasNotChanged)
{
    run("");
    const JobRun again = run("");
    EXPECT_THAT(calls(), IsEmpty());
    EXPECT_EQ(state_of(again, JobStep::Plan), StepState::UpToDate);
    EXPECT_THAT(content_of(out() / "job.json"), HasSubstr("\"up to date\""));
}

TEST_F(JobRuns, RepeatsAStepWhoseOptionsChanged)
{
    run("");
    run(R"("verify": {"resolution": 0.5})");
    EXPECT_THAT(calls(), ElementsAre("verify"));
}

TEST_F(JobRuns, RepeatsAStepWhoseInputChanged)
{
    run("");
    folder_.write("part.json", "{ }");
    run("");
    EXPECT_THAT(calls(), ElementsAre("plan", "verify", "post"));
}

TEST_F(JobRuns, RepeatsAStepWhoseResultsChanged)
{
    run("");
    put(out() / "07-post/summary.json", "{}");
    run("");
    EXPECT_THAT(calls(), ElementsAre("post"));
    fs::remove_all(out() / "05-verify");
    run("");
    EXPECT_THAT(calls(), ElementsAre("verify"));
}

TEST_F(JobRuns, DoesNotCountMeasuredTimesAsAChange)
{
    run("");
    JobRunOptions options;
    options.only = JobStep::Plan;
    run("", options);  // writes another work_s into its summary.json
    EXPECT_THAT(calls(), ElementsAre("plan"));
    run("");
    EXPECT_THAT(calls(), IsEmpty());
}

TEST_F(JobRuns, RunsFromAStepOn)
{
    run("");
    JobRunOptions options;
    options.from = JobStep::Verify;
    run("", options);
    EXPECT_THAT(calls(), ElementsAre("verify", "post"));
}

TEST_F(JobRuns, RunsOneStepOnly)
{
    JobRunOptions options;
    options.only = JobStep::Post;
    EXPECT_THROW(run("", options), Error);
    run("");
    run("", options);
    EXPECT_THAT(calls(), ElementsAre("post"));
}

TEST_F(JobRuns, ADryRunChangesNothing)
{
    JobRunOptions options;
    options.dry_run = true;
    const JobRun first = run("", options);
    EXPECT_EQ(state_of(first, JobStep::Plan), StepState::WouldRun);
    EXPECT_FALSE(fs::exists(out()));
    run("");
    const std::string before = content_of(out() / "job.json");
    folder_.write("part.json", "[]");
    const JobRun second = run("", options);
    EXPECT_THAT(second.steps.at(1).reason, HasSubstr("part.json has changed"));
    EXPECT_EQ(content_of(out() / "job.json"), before);
    EXPECT_THAT(calls(), IsEmpty());
}

constexpr const char* failing_verify =
    R"(if [ "$1" = verify ]; then
         echo '{"error": {"code": "E_JSON", "message": "found 1; expected 2"}}' >&2
         exit 3
       fi)";

TEST_F(JobRuns, StopsAtAStepThatFails)
{
    const JobRun stopped = run("", {}, failing_verify);
    EXPECT_EQ(stopped.exit, 3);
    EXPECT_EQ(stopped.code, "E_JSON");
    EXPECT_EQ(stopped.message, "verify: found 1; expected 2");
    EXPECT_THAT(calls(), ElementsAre("plan", "verify"));
    EXPECT_EQ(state_of(stopped, JobStep::Plan), StepState::Done);
    EXPECT_EQ(state_of(stopped, JobStep::Verify), StepState::Failed);
    EXPECT_EQ(state_of(stopped, JobStep::Post), StepState::NotRun);
    EXPECT_TRUE(fs::exists(out() / "02-plan/toolpath.csv"));
    run("");
    EXPECT_THAT(calls(), ElementsAre("verify", "post"));
}

TEST_F(JobRuns, SaysWhatMayHelpAgainstANo)
{
    const JobRun stopped = run("", {}, R"([ "$1" = plan ] && exit 1 || exit 0)");
    EXPECT_EQ(stopped.exit, 1);
    EXPECT_THAT(stopped.message,
                AllOf(StartsWith("plan: "), HasSubstr("accept_no [\"plan\"]")));
}

TEST_F(JobRuns, GoesOnAfterANoThatTheJobAccepts)
{
    const char* const script = R"([ "$1" = plan ] && exit 1 || exit 0)";
    EXPECT_EQ(run(R"("accept_no": ["plan"])", {}, script).exit, 0);
    EXPECT_THAT(calls(), ElementsAre("plan", "verify", "post"));
    EXPECT_THAT(warnings_, ElementsAre(StartsWith("plan: the answer is no")));
    // What is accepted may change without a new run of the step, but not back.
    run("", {}, script);
    EXPECT_THAT(calls(), ElementsAre("plan"));
}

TEST_F(JobRuns, TrimsOnlyIfThePlanGouges)
{
    run(R"("plan": true, "trim": true)");
    EXPECT_THAT(calls(), ElementsAre("plan", "verify", "post"));
    fs::remove_all(out());
    run(R"("plan": true, "trim": true)", {},
        R"([ "$1" = plan ] && {
             echo '{"max_gouge_mm": 1, "inner_tolerance_mm": 0.1}' > "$out/summary.json"
             exit 1; } || exit 0)");
    EXPECT_THAT(calls(), ElementsAre("plan", "trim", "verify", "post"));
    // Trimming does not help against another no.
    fs::remove_all(out());
    EXPECT_EQ(
        run(R"("plan": true, "trim": true)", {}, R"([ "$1" = plan ] && exit 1 || exit 0)")
            .exit,
        1);
}

TEST_F(JobRuns, ReportsAStepThatASignalEnded)
{
    const JobRun stopped = run("", {}, R"([ "$1" = plan ] && kill -9 $$)");
    EXPECT_EQ(stopped.exit, 137);
    EXPECT_THAT(stopped.message, HasSubstr("ended by signal 9"));
}

TEST_F(JobRuns, PassesOnWarningsAndProgress)
{
    std::vector<std::string> work;
    JobRunOptions options;
    options.progress = [&](const JobProgress& progress) {
        if (!progress.ended)
            work.push_back(progress.work);
    };
    run("", options,
        R"([ "$1" = plan ] && { echo 'endmill: warning: thin' >&2
             echo '{"progress": {"work": "planning", "share": 0.5, "left_s": null}}' >&2; } ; true)");
    EXPECT_THAT(warnings_, ElementsAre("plan: thin"));
    EXPECT_THAT(work, ElementsAre("planning"));
}

TEST_F(JobRuns, RemovesTheResultsOfAStepThatIsNoLongerNeeded)
{
    run(R"("machine": "W/caxyBz/T")");
    EXPECT_TRUE(fs::exists(out() / "01-setup"));
    run("");
    EXPECT_FALSE(fs::exists(out() / "01-setup"));
}

TEST_F(JobRuns, RefusesAFolderOfAnotherOrigin)
{
    put(out() / "letter.txt", "Dear");
    EXPECT_THROW(run(""), DomainError);
    JobRunOptions options;
    options.accepts_full_folder = true;
    EXPECT_EQ(run("", options).exit, 0);
}

TEST_F(JobRuns, RefusesAPartAmongItsOwnResults)
{
    folder_.write("part.json", "{}");
    const ProgramDescription program = job_program(folder_.path());
    const Job job =
        parse_job(R"({"format": "endmill-job/1", "part": {"file": "part.json"}})",
                  folder_.path() / "job-file.json", program);
    JobRunOptions options;
    options.folder = folder_.path();
    options.accepts_full_folder = true;
    EXPECT_THROW(run_job(job, program, options), DomainError);
}

TEST_F(JobRuns, GoesOnAfterAnInterruptionWithTheSameRecord)
{
    run("");
    const std::string whole = content_of(out() / "job.json");
    // As a run that was killed while it verified leaves the folder.
    std::string cut = whole;
    cut.replace(cut.find("\"finished\": true,\n  \"exit\": 0"),
                std::string{"\"finished\": true,\n  \"exit\": 0"}.size(),
                "\"finished\": false");
    put(out() / "job.json", cut);
    fs::remove_all(out() / "05-verify");
    run("");
    EXPECT_THAT(calls(), ElementsAre("verify"));
    EXPECT_THAT(content_of(out() / "job.json"), testing::Not(HasSubstr("up to date")));
}

}  // namespace
}  // namespace endmill
