// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/job/job_step.h"

/// \file
/// job.json ("endmill-job-state/1"): what became of each step, and what it depends on.

namespace endmill {

/// An input of a step and its content.
struct InputHash {
    std::string file;    ///< path from the folder of the job's results
    std::string sha256;  ///< `result_sha256`
};

/// What a step depends on, and what it produced.
struct StepRecord {
    StepState state = StepState::NotRun;    ///< what became of it
    std::string reason = {};                ///< as StepResult::reason
    int exit = 0;                           ///< exit code of its command
    double wall_s = 0;                      ///< s, that its command took
    std::vector<std::string> command = {};  ///< with paths from the folder of the results
    std::vector<InputHash> inputs = {};     ///< all files that it reads
    std::string sha256 = {};          ///< of the version, the command and the inputs
    std::string results_sha256 = {};  ///< `folder_sha256` of its folder
    std::vector<std::string> warnings = {};  ///< of its command
};

/// The content of job.json.
struct JobRecord {
    std::string name = {};     ///< of the job
    std::string version = {};  ///< of the program
    bool is_finished = false;  ///< whether the run came to its end
    int exit = 0;              ///< of the run, once it is finished
    std::array<StepRecord, job_step_count> steps = {};  ///< in the order of JobStep
};

/// The SHA-256 of all that a step depends on.
std::string step_sha256(const std::string& version,
                        const std::vector<std::string>& command,
                        const std::vector<InputHash>& inputs);

/// The content of job.json.
std::string job_record_text(const JobRecord& record);

/// Parses the content of job.json.
/// \return nothing if it is not as `job_record_text` writes it.
std::optional<JobRecord> parse_job_record(std::string_view content);

/// Reads job.json in a folder.
/// \return nothing if there is none that `parse_job_record` accepts.
std::optional<JobRecord> read_job_record(const std::filesystem::path& folder);

}  // namespace endmill
