// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "endmill/job/job_run.h"

namespace endmill {

/// Options of `endmill run`.
struct RunOptions {
    std::string file;                   ///< of the job
    std::vector<std::string> settings;  ///< KEY=VALUE
    std::optional<JobStep> from, only;  ///< as JobRunOptions
    bool dry_run = false;               ///< as JobRunOptions
    CommonOptions common;               ///< those of every command
};

/// Adds the options of the command. \param options outlives `command`.
void add_run_options(CLI::App& command, RunOptions& options);

/// Runs a job, prints its steps and reports the one that failed.
/// \param program what its commands accept.
ExitCode run_job_command(const RunOptions& options, const ProgramDescription& program);

}  // namespace endmill
