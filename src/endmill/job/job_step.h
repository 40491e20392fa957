// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

/// \file
/// The steps of a job and what becomes of them.

namespace endmill {

/// The steps of the chain, in their order.
enum class JobStep {
    Setup,   ///< how the part stands on the machine
    Plan,    ///< the tool path
    Trim,    ///< the tool path from trimmed sections of the offset, which does not gouge
    Feed,    ///< feed and spindle speed of each move
    Verify,  ///< the verdict on the path
    Clamp,   ///< where the part is clamped so that the machine runs the path
    Post,    ///< the program of the machine
};

/// The names of the steps in files and messages, in the order of the enumeration.
inline constexpr std::array<std::string_view, 7> job_step_names{
    "setup", "plan", "trim", "feed", "verify", "clamp", "post"};

/// Number of steps.
inline constexpr std::size_t job_step_count = job_step_names.size();

/// The name of a step.
inline std::string_view job_step_name(JobStep step)
{
    return job_step_names.at(static_cast<std::size_t>(step));
}

/// The command of the program that does a step.
inline std::string_view job_step_command(JobStep step)
{
    return step == JobStep::Clamp ? "setup" : job_step_name(step);
}

/// What became of a step.
enum class StepState {
    Done,       ///< it ran in this run, or in an earlier part of it that was interrupted
    UpToDate,   ///< it ran earlier, and nothing that it depends on has changed since
    NotNeeded,  ///< the job does not need it
    Failed,     ///< it ended with an error, or its answer is no
    NotRun,     ///< it was not reached
    WouldRun,   ///< it is not up to date (dry run)
};

/// The words for the states in files and messages, in the order of the enumeration.
inline constexpr std::array<std::string_view, 6> step_state_words{
    "done", "up to date", "not needed", "failed", "not run", "would run"};

/// The word for a state.
inline std::string word_of(StepState state)
{
    return std::string{step_state_words.at(static_cast<std::size_t>(state))};
}

/// A step and what became of it.
struct StepResult {
    JobStep step;                       ///< which one
    StepState state;                    ///< what became of it
    std::string reason = {};            ///< why it was not needed, failed or would run
    int exit = 0;                       ///< exit code of its command
    double wall_s = 0;                  ///< s, that its command took
    std::filesystem::path folder = {};  ///< of its results
};

}  // namespace endmill
