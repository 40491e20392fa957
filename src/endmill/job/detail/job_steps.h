// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "endmill/job/job_file.h"

/// \file
/// The commands of the chain: which steps a job needs, and what each one reads.

namespace endmill {

/// The folder of a step's results, such as "02-plan".
std::string job_step_folder(JobStep step);

/// Whether the tool stands still while it cuts, in one of several setups (3+2 axes).
bool plans_from_setups(const Job& job);

/// Whether trimmed sections take the place of a plan that gouges: if the job asks for them, or
/// plans as a paper does, which may gouge.
bool trims_gouges(const Job& job);

/// Whether the path of a plan whose answer is no gouges deeper than the inner tolerance.
/// \param folder of the results of the job.
/// \throws FormatError if the results of the plan cannot be read.
bool plan_gouges(const std::filesystem::path& folder);

/// A run of a command for a step.
struct StepCommand {
    std::filesystem::path input;                ///< file that it works on
    std::vector<GivenOption> options = {};      ///< all that it is given
    std::vector<std::filesystem::path> beside;  ///< other files that it reads
};

/// Why a step does not run.
struct StepNotNeeded {
    std::string reason;  ///< such as "the machine has three axes"
};

/// What is known of the chain when a step is due.
struct ChainState {
    std::filesystem::path folder;  ///< of the results of the job
    /// Whether a step has run in this chain or is up to date, in the order of JobStep.
    std::array<bool, job_step_count> is_done = {};
    bool plan_gouges = false;  ///< as `plan_gouges` finds
};

/// The command of a step.
/// \param state of the chain after the steps before this one.
std::variant<StepCommand, StepNotNeeded> step_command(const Job& job, JobStep step,
                                                      const ChainState& state);

}  // namespace endmill
