// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "endmill/job/job_file.h"
#include "endmill/job/job_step.h"

/// \file
/// Runs the chain of a job. Each step is a run of the program in a folder of its own, and a
/// step whose inputs have not changed is not repeated.

namespace endmill {

/// Progress of a run.
struct JobProgress {
    JobStep step;                       ///< at work
    std::string work = {};              ///< what the command says of its work
    std::optional<double> share = {};   ///< of that work, 0 to 1
    std::optional<double> left_s = {};  ///< s, estimate for this step and those after it
    std::optional<StepResult> ended = {};  ///< set at the end of the step
};

/// Options of a run.
struct JobRunOptions {
    std::filesystem::path folder;  ///< for the results
    std::optional<JobStep> from;   ///< this step and those after it run in any case
    std::optional<JobStep> only;   ///< no other step runs
    bool dry_run = false;          ///< find out what would run, and change nothing
    /// Whether the folder may hold files of another origin.
    bool accepts_full_folder = false;
    std::vector<std::string> arguments = {};  ///< for all commands, such as "--threads=2"
    std::function<void(const JobProgress&)> progress = {};  ///< called by one thread
    std::function<void(const std::string&)> warning = {};   ///< a warning of a step
};

/// The end of a run.
struct JobRun {
    int exit = 0;              ///< that of the failed step, or 0
    std::string code = {};     ///< of the error of the failed step, such as "E_JSON"
    std::string message = {};  ///< of the failed step: what, and what to change
    std::vector<StepResult> steps = {};  ///< all steps, in their order
};

/// Runs the steps of a job that are not up to date, and writes job.json beside their folders
/// (format "endmill-job-state/1"): for each step its state, the command, the time, and the
/// SHA-256 of all that it depends on. job.json is replaced after each step, so that a run
/// that was killed goes on where it was; its results then have the same bytes as those of a
/// run without interruption, measured times excepted.
///
/// A step is up to date if the version of the program, its options, the content of each input
/// and that of its own results are those of its last run.
/// \throws DomainError if the folder holds other files, if the job or a file that it names is
///         in it, or if `only` names a step whose inputs are missing.
/// \throws OutputError if another process runs in the folder, or job.json cannot be written.
JobRun run_job(const Job& job, const ProgramDescription& program,
               const JobRunOptions& options);

}  // namespace endmill
