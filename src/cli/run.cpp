// SPDX-License-Identifier: GPL-3.0-or-later
// endmill run: the chain from a part to its program, step by step.

#include <array>
#include <cstdio>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/program_description.h"
#include "cli/progress.h"
#include "cli/run_options.h"
#include "cli/surface_facts.h"
#include "cli/view.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

constexpr std::array step_choices{
    Choice<JobStep>{"setup", JobStep::Setup},   Choice<JobStep>{"plan", JobStep::Plan},
    Choice<JobStep>{"trim", JobStep::Trim},     Choice<JobStep>{"feed", JobStep::Feed},
    Choice<JobStep>{"verify", JobStep::Verify}, Choice<JobStep>{"clamp", JobStep::Clamp},
    Choice<JobStep>{"post", JobStep::Post}};

std::string folder_name(const StepResult& step)
{
    return step.folder.filename().string();
}

// "done in 1.2 s", "failed after 3 s" or the word of another state.
std::string state_text(const StepResult& step)
{
    if (step.state == StepState::Done)
        return fmt::format("done in {:.1f} s", step.wall_s);
    if (step.state == StepState::Failed)
        return fmt::format("failed after {:.1f} s", step.wall_s);
    return word_of(step.state);
}

// Shows the progress of a run on standard error: on a terminal also that of the running step.
class RunProgress {
public:
    explicit RunProgress(const CommonOptions& options) : options_{options} {}

    void show(const JobProgress& progress)
    {
        if (options_.quiet)
            return;
        if (options_.json_progress)
            print_object(progress);
        else if (progress.ended && progress.ended->wall_s > 0 &&
                 (progress.ended->state == StepState::Done ||
                  progress.ended->state == StepState::Failed))
            print_end(progress);
        else if (progress.ended)
            return;  // the text at the end names it
        else
            show_work(progress);
    }

    void end() { line_.reset(); }  // of the step at work

private:
    void show_work(const JobProgress& progress)
    {
        const std::string name{job_step_name(progress.step)};
        if (!line_)
            line_ = std::make_unique<ProgressLine>(name, options_);
        std::string state = progress.work;
        if (progress.share)
            state += fmt::format(" {:.0f} %", 100 * *progress.share);
        if (progress.left_s)
            state += fmt::format(", about {} left", waiting_time(*progress.left_s));
        line_->show(std::move(state));
    }

    void print_end(const JobProgress& progress)
    {
        end();
        std::string line = fmt::format("endmill: {}: {}", folder_name(*progress.ended),
                                       state_text(*progress.ended));
        if (progress.left_s && *progress.left_s > 0)
            line += fmt::format(", about {} left", waiting_time(*progress.left_s));
        std::fprintf(stderr, "%s\n", line.c_str());
    }

    static Json number_or_null(const std::optional<double>& number)
    {
        return number ? Json(*number) : Json(nullptr);
    }

    static void print_object(const JobProgress& progress)
    {
        Json state{{"step", job_step_name(progress.step)}};
        if (progress.ended) {
            state["state"] = word_of(progress.ended->state);
            state["wall_s"] = progress.ended->wall_s;
        } else {
            state["work"] = progress.work;
            state["share"] = number_or_null(progress.share);
        }
        state["left_s"] = number_or_null(progress.left_s);
        const Json object{{"progress", state}};
        std::fprintf(stderr, "%s\n",
                     object.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
        std::fflush(stderr);
    }

    const CommonOptions& options_;
    std::unique_ptr<ProgressLine> line_;
};

Json summary_of(const JobRun& run)
{
    Json summary{{"exit", run.exit}};
    if (!run.message.empty())
        summary["message"] = run.message;
    for (const StepResult& step : run.steps) {
        Json& shown = summary["steps"][std::string{job_step_name(step.step)}];
        shown = {{"state", word_of(step.state)}};
        if (!step.reason.empty())
            shown["reason"] = step.reason;
        if (step.state == StepState::NotNeeded || step.state == StepState::WouldRun ||
            step.state == StepState::NotRun)
            continue;
        shown["folder"] = folder_name(step);
        shown["exit"] = step.exit;
        shown["wall_s"] = step.wall_s;
    }
    return summary;
}

std::string text_of(const JobRun& run, const RunOptions& options,
                    const std::string& folder)
{
    std::string text;
    for (const StepResult& step : run.steps) {
        text += fmt::format("{:<10} {}", folder_name(step), state_text(step));
        if (!step.reason.empty() && step.state != StepState::Failed)
            text += ": " + step.reason;
        text += '\n';
    }
    if (!options.dry_run)
        text += "written to " + printable(folder) + "\n";
    return text;
}

// The options of every command that each step gets too.
std::vector<std::string> step_arguments(const CommonOptions& common)
{
    std::vector<std::string> arguments;
    if (common.threads)
        arguments.push_back(fmt::format("--threads={}", *common.threads));
    if (common.given.contains("--max-memory"))
        arguments.push_back("--max-memory=" + to_text(common.limits.max_memory_gib));
    if (common.given.contains("--max-extent"))
        arguments.push_back("--max-extent=" + to_text(common.limits.max_extent_mm));
    return arguments;
}

}  // namespace

void add_run_options(CLI::App& command, RunOptions& options)
{
    command.add_option("JOB", options.file, "job file (endmill-job/1)")->required();
    add_choice<JobStep>(command, "--from", options.from, step_choices,
                        "run this step and those after it, even if they are up to date");
    add_choice<JobStep>(command, "--only", options.only, step_choices,
                        "run only this step, on the results of the earlier ones");
    command
        .add_option("--set", options.settings,
                    "value that replaces one of the job, such as plan.scallop=0.1; as "
                    "often as needed")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    command.add_flag("--dry-run", options.dry_run,
                     "print which steps would run, and why; change nothing");
    add_html_option(command, options.common);
    add_common_options(command, options.common);
}

ExitCode run_job_command(const RunOptions& options, const ProgramDescription& program)
{
    if (options.from && options.only)
        throw DomainError{"--from and --only: expected one of them"};
    std::vector<JobSetting> settings;
    for (const std::string& text : options.settings)
        settings.push_back(job_setting(text));
    const Job job = read_job(options.file, program, settings, options.common.limits);
    const std::string folder = output_folder(options.file, "run", options.common);
    RunProgress progress{options.common};
    JobRunOptions running{
        .folder = folder,
        .from = options.from,
        .only = options.only,
        .dry_run = options.dry_run,
        .accepts_full_folder = options.common.full_folder == FullFolder::Accept,
        .arguments = step_arguments(options.common)};
    running.progress = [&](const JobProgress& state) { progress.show(state); };
    running.warning = [&](const std::string& text) {
        progress.end();
        warn(options.common, text);
    };
    const JobRun run = run_job(job, program, running);
    progress.end();
    if (!options.dry_run && (run.exit == 0 || run.exit == 1))
        write_html(folder, options.common);
    print_result(options.common, summary_of(run), text_of(run, options, folder));
    if (run.exit != 0)
        report_error(run.code, run.message, static_cast<ExitCode>(run.exit),
                     options.common.json_errors);
    return static_cast<ExitCode>(run.exit);
}

void add_run_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "run", "run a job: the whole chain from a part to its program");
    const auto options = std::make_shared<RunOptions>();
    add_run_options(*command, *options);
    command->footer(
        "A job names the part, the machine, the tool and what is asked of each step:\n"
        "setup, plan, trim, feed, verify, clamp, post. Each step is a command of "
        "endmill\n"
        "and writes to its own folder of --output (default ./NAME-run): 01-setup, "
        "02-plan,\n"
        "and so on. job.json states what became of each step.\n\n"
        "A step whose options and inputs have not changed is not run again. A run that\n"
        "was interrupted goes on where it was. docs/guide/jobs.md describes the file.\n\n"
        "The exit code is that of the step that failed, or 0.\n\n"
        "Example:\n"
        "  endmill run datasets/jobs/economic-cl-data.json -o saddle-job\n"
        "  endmill run datasets/jobs/economic-cl-data.json -o saddle-job --set "
        "plan.scallop=0.2 "
        "--dry-run");
    command->callback([options, &action, &program] {
        action = [options, &program] {
            return run_job_command(*options, description_of(program));
        };
    });
}

}  // namespace endmill
