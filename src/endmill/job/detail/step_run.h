// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "endmill/job/job_step.h"

/// \file
/// The run of one step's command, and what it said.

namespace endmill {

/// Progress that a command reports of its work.
struct WorkProgress {
    std::string work;                   ///< what it does, such as "planning"
    std::optional<double> share = {};   ///< of that work, 0 to 1
    std::optional<double> left_s = {};  ///< s, its estimate
};

/// The command of a step.
struct StepRun {
    JobStep step;                             ///< whose command it is
    std::filesystem::path program;            ///< absolute path of the program
    std::vector<std::string> arguments = {};  ///< after the name of the command
    std::filesystem::path folder = {};        ///< for its results
    std::function<void(const WorkProgress&)> progress = {};  ///< may be empty
    std::function<void(const std::string&)> warning = {};    ///< may be empty
};

/// How a command ended.
struct StepEnd {
    int exit = 0;           ///< its exit code; 128 + N if signal N ended it
    bool is_no = false;     ///< whether it ended by itself and its answer is no
    std::string code = {};  ///< of its error, such as "E_JSON"; "E_STEP" if it names none
    std::string reason = {};                 ///< why the exit code is not 0
    std::vector<std::string> warnings = {};  ///< in their order
    double wall_s = 0;                       ///< s, that it took
};

/// Runs the command of a step as a child process and waits for its end.
/// \throws OutputError as `run_child`; FormatError if the answer of `verify` is no and its
///         summary cannot be read.
StepEnd run_step(const StepRun& run);

/// What may help where the answer of a step is no: keys of the job and their values.
std::string advice_for(JobStep step);

}  // namespace endmill
