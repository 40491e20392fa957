// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/job_run.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <variant>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/read_file.h"
#include "endmill/job/detail/file_hash.h"
#include "endmill/job/detail/job_record.h"
#include "endmill/job/detail/job_steps.h"
#include "endmill/job/detail/step_run.h"
#include "endmill/job/folder_lock.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr const char* record_name = "job.json";

fs::path whole_path(const fs::path& path)
{
    return fs::absolute(path).lexically_normal();
}

std::string name_of(JobStep step)
{
    return std::string{job_step_name(step)};
}

class Runner {
public:
    Runner(const Job& job, const ProgramDescription& program,
           const JobRunOptions& options)
        : job_{job},
          program_{program},
          options_{options},
          folder_{options.folder.lexically_normal()}
    {
        state_.folder = folder_;
        record_.name = job.name;
        record_.version = program.version;
    }

    JobRun run();

private:
    std::size_t at(JobStep step) const { return static_cast<std::size_t>(step); }
    fs::path folder_of(JobStep step) const { return folder_ / job_step_folder(step); }
    std::string from_folder(const fs::path& file) const;

    void require_own_folder() const;
    void require_outside(const fs::path& file) const;
    void require_job_outside() const;
    void require_inputs(JobStep step, const StepCommand& command) const;
    bool is_asked(JobStep step) const;
    bool must_run(JobStep step) const;
    bool goes_on_after_no(JobStep step) const;

    StepRecord record_if_run(JobStep step, const StepCommand& command) const;
    std::string why_not_up_to_date(JobStep step, const StepRecord& now) const;
    void do_step(JobStep step);
    void mark_not_needed(JobStep step, const std::string& reason);
    void mark_up_to_date(JobStep step);
    void execute(JobStep step, const StepCommand& command, StepRecord record);
    StepRun run_of(JobStep step, const StepCommand& command) const;
    void judge(JobStep step, const StepEnd& end);
    std::string key_in(std::string_view message, JobStep step) const;
    void warn(JobStep step, const std::string& text) const;
    void note_answer(JobStep step);
    void report(const JobProgress& progress) const;
    std::optional<double> seconds_after(JobStep step) const;
    void report_end(JobStep step) const;
    void remove_earlier_results(JobStep step) const;
    void write_record();
    void read_earlier();
    void take_earlier_result(JobStep step);
    void foresee(JobStep step);
    void do_steps();
    JobRun outcome() const;

    const Job& job_;
    const ProgramDescription& program_;
    const JobRunOptions& options_;
    fs::path folder_;
    ChainState state_;
    std::optional<JobRecord> earlier_;
    JobRecord record_;
    bool is_foreseen_ = false;  // a dry run has met a step that would run
    std::optional<JobStep> failed_;
    std::string code_;
    std::string message_;
};

std::string Runner::from_folder(const fs::path& file) const
{
    return whole_path(file).lexically_relative(whole_path(folder_)).generic_string();
}

// Refuses a folder with files that no run of a job made.
void Runner::require_own_folder() const
{
    std::error_code error;
    if (options_.accepts_full_folder || !fs::exists(folder_, error) ||
        read_job_record(folder_))
        return;
    if (!fs::is_directory(folder_, error))
        throw DomainError{"--output: " + shown_path(options_.folder) +
                          " is a file; expected a folder"};
    for (const auto& entry : fs::directory_iterator{folder_, error})
        if (!entry.path().filename().string().starts_with(".endmill-"))
            throw DomainError{"--output: " + shown_path(options_.folder) +
                              " is not empty and has no job.json that a run wrote; "
                              "expected the folder of a job, a new one, or --force"};
}

// Refuses a file of the job inside the folder of the results: a step could replace it.
void Runner::require_outside(const fs::path& file) const
{
    const fs::path relative = whole_path(file).lexically_relative(whole_path(folder_));
    if (!relative.empty() && *relative.begin() != "..")
        throw DomainError{"--output: " + shown_path(file) +
                          ", which the job needs, is in this folder for its results; "
                          "expected another folder"};
}

void Runner::require_job_outside() const
{
    require_outside(job_.file);
    require_outside(job_.part);
    for (const auto& option : {job_.protect, job_.skip_facets, job_.machine, job_.tool,
                               job_.material, job_.control, job_.stock})
        if (option && option->is_file)
            require_outside(*option->value);
    for (const StepRequest& request : job_.steps)
        for (const GivenOption& option : request.options)
            if (option.is_file)
                require_outside(*option.value);
}

void Runner::require_inputs(JobStep step, const StepCommand& command) const
{
    std::error_code error;
    const auto require = [&](const fs::path& file) {
        if (!fs::exists(file, error))
            throw DomainError{"--only " + name_of(step) + ": found no " +
                              shown_path(file) +
                              "; expected a run without --only before"};
    };
    require(command.input);
    for (const GivenOption& option : command.options)
        if (option.is_file)
            require(*option.value);
}

bool Runner::is_asked(JobStep step) const
{
    return !options_.only || *options_.only == step;
}

bool Runner::must_run(JobStep step) const
{
    return (options_.only && *options_.only == step) ||
           (options_.from && *options_.from <= step);
}

// Whether the chain goes on if the answer of a step is no. Several setups are asked for
// because one does not suffice; trimmed sections take the place of a plan that gouges.
bool Runner::goes_on_after_no(JobStep step) const
{
    return job_.request(step).accepts_no ||
           (step == JobStep::Setup && plans_from_setups(job_)) ||
           (step == JobStep::Plan && trims_gouges(job_) && plan_gouges(folder_));
}

// The record of a step as it would be if it ran now.
StepRecord Runner::record_if_run(JobStep step, const StepCommand& command) const
{
    StepRecord record;
    record.command = {std::string{job_step_command(step)}, from_folder(command.input)};
    std::vector<fs::path> files{command.input};
    files.insert(files.end(), command.beside.begin(), command.beside.end());
    std::vector<GivenOption> shown = command.options;
    for (GivenOption& option : shown)
        if (option.is_file) {
            files.emplace_back(*option.value);
            option.value = from_folder(*option.value);
        }
    for (std::string& word : arguments_of(shown))
        record.command.push_back(std::move(word));
    for (const fs::path& file : files) {
        std::string name = from_folder(file);
        if (std::ranges::find(record.inputs, name, &InputHash::file) ==
            record.inputs.end())
            record.inputs.push_back({std::move(name), result_sha256(file)});
    }
    record.sha256 = step_sha256(program_.version, record.command, record.inputs);
    return record;
}

// The reason why a step must run; empty if it is up to date.
std::string Runner::why_not_up_to_date(JobStep step, const StepRecord& now) const
{
    if (must_run(step))
        return "as asked";
    if (!earlier_)
        return "there is no earlier run";
    const StepRecord& last = earlier_->steps.at(at(step));
    if (last.state == StepState::Failed)
        return "it failed";
    if (last.command.empty())
        return "it has not run yet";
    if (last.sha256 != now.sha256) {
        if (earlier_->version != program_.version)
            return "it was made by endmill " + printable(earlier_->version, 40);
        if (last.command != now.command)
            return "its options have changed";
        for (const InputHash& input : now.inputs) {
            const auto found =
                std::ranges::find(last.inputs, input.file, &InputHash::file);
            if (found == last.inputs.end() || found->sha256 != input.sha256)
                return printable(input.file) + " has changed";
        }
        return "its inputs have changed";
    }
    try {
        if (folder_sha256(folder_of(step)) == last.results_sha256)
            return last.exit == 0 || goes_on_after_no(step) ? "" : "its answer was no";
    } catch (const FormatError&) {
        return "its results are missing";
    }
    return "its results were changed";
}

void Runner::mark_not_needed(JobStep step, const std::string& reason)
{
    record_.steps.at(at(step)) = {.state = StepState::NotNeeded, .reason = reason};
    remove_earlier_results(step);
    report_end(step);
}

// A step that is up to date.
void Runner::mark_up_to_date(JobStep step)
{
    StepRecord& record = record_.steps.at(at(step));
    if (record.state != StepState::Done)
        record.state = StepState::UpToDate;
    note_answer(step);
    report_end(step);
}

// Notes for the steps that follow that this one has results.
void Runner::note_answer(JobStep step)
{
    state_.is_done.at(at(step)) = true;
    if (step == JobStep::Plan)
        state_.plan_gouges = record_.steps.at(at(step)).exit == 1 && plan_gouges(folder_);
}

void Runner::do_step(JobStep step)
{
    const auto choice = step_command(job_, step, state_);
    if (const auto* not_needed = std::get_if<StepNotNeeded>(&choice)) {
        if (options_.only)
            throw DomainError{"--only " + name_of(step) + ": the step is not needed: " +
                              not_needed->reason + "; expected another step"};
        mark_not_needed(step, not_needed->reason);
        return;
    }
    const auto& command = std::get<StepCommand>(choice);
    if (options_.only)
        require_inputs(step, command);
    StepRecord record = record_if_run(step, command);
    const std::string reason = why_not_up_to_date(step, record);
    if (reason.empty())
        mark_up_to_date(step);
    else if (options_.dry_run) {
        record_.steps.at(at(step)) = {.state = StepState::WouldRun, .reason = reason};
        state_.is_done.at(at(step)) = true;
        is_foreseen_ = true;
    } else {
        execute(step, command, std::move(record));
    }
}

StepRun Runner::run_of(JobStep step, const StepCommand& command) const
{
    const bool is_path = step == JobStep::Clamp;
    StepRun run{.step = step,
                .program = program_.program,
                .arguments = {(is_path ? "--path=" : "") + command.input.string()},
                .folder = folder_of(step)};
    for (std::string& word : arguments_of(command.options))
        run.arguments.push_back(std::move(word));
    run.arguments.insert(run.arguments.end(), options_.arguments.begin(),
                         options_.arguments.end());
    run.progress = [this, step](const WorkProgress& work) {
        JobProgress progress{step, work.work, work.share};
        if (work.left_s)
            progress.left_s = *work.left_s + seconds_after(step).value_or(0);
        report(progress);
    };
    run.warning = [this, step](const std::string& text) { warn(step, text); };
    return run;
}

// The time of the steps after this one, as they took earlier; nothing if it is not known.
std::optional<double> Runner::seconds_after(JobStep step) const
{
    if (!earlier_)
        return step == JobStep::Post ? std::optional{0.0} : std::nullopt;
    double seconds = 0;
    for (std::size_t i = at(step) + 1; i < job_step_count; ++i)
        seconds += earlier_->steps.at(i).wall_s;
    return seconds;
}

void Runner::report(const JobProgress& progress) const
{
    if (options_.progress)
        options_.progress(progress);
}

// Runs the command of a step. Its record is written when its results are complete.
void Runner::execute(JobStep step, const StepCommand& command, StepRecord record)
{
    std::error_code error;
    if (!earlier_ && fs::exists(folder_of(step), error))
        throw DomainError{shown_path(folder_of(step)) +
                          " exists and is of no run of a job; expected another --output"};
    fs::remove_all(folder_of(step), error);
    if (error)
        throw OutputError{"cannot remove the results of the earlier run in " +
                          shown_path(folder_of(step)) + ": " + error.message()};
    record_.steps.at(at(step)) = {};
    write_record();
    const StepEnd end = run_step(run_of(step, command));
    record.wall_s = end.wall_s;
    record.warnings = end.warnings;
    record_.steps.at(at(step)) = std::move(record);
    judge(step, end);
    StepRecord& judged = record_.steps.at(at(step));
    if (fs::exists(folder_of(step), error))
        judged.results_sha256 = folder_sha256(folder_of(step));
    write_record();
    report_end(step);
}

void Runner::report_end(JobStep step) const
{
    const StepRecord& record = record_.steps.at(at(step));
    if (!options_.dry_run)
        report({step,
                {},
                {},
                seconds_after(step),
                StepResult{step, record.state, record.reason, record.exit, record.wall_s,
                           folder_of(step)}});
}

// Removes what an earlier run of a step left, since it no longer belongs to the job.
void Runner::remove_earlier_results(JobStep step) const
{
    const bool was_made = earlier_ && !earlier_->steps.at(at(step)).command.empty();
    std::error_code ignored;  // what stays is in no record
    if (was_made && !options_.dry_run)
        fs::remove_all(folder_of(step), ignored);
}

// Notes how a command ended.
void Runner::judge(JobStep step, const StepEnd& end)
{
    StepRecord& record = record_.steps.at(at(step));
    record.state = StepState::Done;
    record.exit = end.exit;
    record.reason = end.reason;
    if (end.exit == 0 || (end.is_no && goes_on_after_no(step))) {
        note_answer(step);
        if (end.is_no)
            warn(step, "the answer is no, and the job goes on: " + end.reason);
        return;
    }
    record.state = StepState::Failed;
    failed_ = step;
    code_ = end.code;
    message_ = name_of(step) + ": " + end.reason;
    const std::string key = key_in(end.reason, step);
    if (!key.empty())
        message_ += " (" + key + " in " + shown_path(job_.file) + ")";
    if (end.is_no)
        message_ += "; in the job, " + advice_for(step) + " may help, and accept_no [\"" +
                    name_of(step) + "\"] lets the chain go on";
}

// The key of the job for the option that a message begins with; empty if the job has none.
std::string Runner::key_in(std::string_view message, JobStep step) const
{
    for (const GivenOption& option : job_.request(step).options)
        if (message.starts_with(option.name + ":"))
            return name_of(step) + "." + ProgramOption{option.name, {}}.key();
    return {};
}

void Runner::warn(JobStep step, const std::string& text) const
{
    if (options_.warning)
        options_.warning(name_of(step) + ": " + text);
}

void Runner::write_record()
{
    write_file(folder_ / record_name, job_record_text(record_));
}

JobRun Runner::outcome() const
{
    JobRun run;
    run.exit = failed_ ? record_.steps.at(at(*failed_)).exit : 0;
    run.code = code_;
    run.message = message_;
    for (std::size_t i = 0; i < job_step_count; ++i) {
        const auto step = static_cast<JobStep>(i);
        const StepRecord& record = record_.steps.at(i);
        run.steps.push_back({step, record.state, record.reason, record.exit,
                             record.wall_s, options_.folder / job_step_folder(step)});
    }
    return run;
}

// Takes over what an earlier run left. Its steps count as done by this run if it was
// interrupted.
void Runner::read_earlier()
{
    earlier_ = read_job_record(folder_);
    if (!earlier_)
        return;
    record_.steps = earlier_->steps;
    if (earlier_->is_finished)
        for (StepRecord& step : record_.steps)
            if (step.state == StepState::Done)
                step.state = StepState::UpToDate;
    earlier_->steps = record_.steps;
}

// A step that is not looked at keeps its results, if it has any.
void Runner::take_earlier_result(JobStep step)
{
    const StepRecord& record = record_.steps.at(at(step));
    if (record.state == StepState::Failed && step < *options_.only)
        throw DomainError{"--only " + name_of(*options_.only) + ": the step " +
                          name_of(step) +
                          " failed; expected a run in which it does not, or " +
                          name_of(step) + " in accept_no"};
    if (!record.command.empty() && record.state != StepState::Failed)
        note_answer(step);
}

// A step after one that would run. Whether it is needed may depend on results that do not
// exist yet.
void Runner::foresee(JobStep step)
{
    StepRecord& record = record_.steps.at(at(step));
    record = {.state = StepState::WouldRun, .reason = "a step before it would run"};
    if (step == JobStep::Trim && trims_gouges(job_) &&
        state_.is_done.at(at(JobStep::Plan))) {
        record.reason = "if the path of the plan gouges";
        return;
    }
    try {
        const auto choice = step_command(job_, step, state_);
        if (const auto* not_needed = std::get_if<StepNotNeeded>(&choice)) {
            record = {.state = StepState::NotNeeded, .reason = not_needed->reason};
            return;
        }
    } catch (const Error&) {
        record.reason =
            "a step before it would run";  // it reads results that are missing
    }
    state_.is_done.at(at(step)) = true;
}

void Runner::do_steps()
{
    for (std::size_t i = 0; i < job_step_count; ++i) {
        const auto step = static_cast<JobStep>(i);
        if (failed_) {
            remove_earlier_results(step);
            record_.steps.at(i) = {.reason = "step " + name_of(*failed_) + " failed"};
        } else if (!is_asked(step))
            take_earlier_result(step);
        else if (is_foreseen_)
            foresee(step);
        else
            do_step(step);
    }
}

JobRun Runner::run()
{
    require_own_folder();
    require_job_outside();
    if (options_.dry_run) {
        read_earlier();
        do_steps();
        return outcome();
    }
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error)
        throw OutputError{"cannot create " + shown_path(folder_) + ": " +
                          error.message()};
    const FolderLock lock{folder_, "a run"};
    read_earlier();
    do_steps();
    record_.is_finished = true;
    record_.exit = failed_ ? record_.steps.at(at(*failed_)).exit : 0;
    write_record();
    return outcome();
}

}  // namespace

JobRun run_job(const Job& job, const ProgramDescription& program,
               const JobRunOptions& options)
{
    return Runner{job, program, options}.run();
}

}  // namespace endmill
