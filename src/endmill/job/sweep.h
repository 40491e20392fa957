// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "endmill/files/output_folder.h"
#include "endmill/job/sweep_plan.h"
#include "endmill/job/sweep_workers.h"

namespace endmill {

/// How far a sweep is.
struct SweepProgress {
    std::uint64_t done = 0;    ///< cases that have ended, also in earlier runs
    std::uint64_t cases = 0;   ///< of the shard
    std::uint64_t failed = 0;  ///< of those that have ended
    std::uint64_t before = 0;  ///< cases that had ended before this run
};

/// How a sweep runs.
struct SweepOptions {
    std::filesystem::path program;                ///< that runs the cases; absolute path
    std::filesystem::path folder;                 ///< for the results
    FullFolder full_folder = FullFolder::Refuse;  ///< that holds other files
    bool resume = false;                      ///< go on with what an earlier run has done
    SweepShard shard = {};                    ///< cases to run
    int jobs = 1;                             ///< cases at the same time
    int threads_of_case = 1;                  ///< threads of each case
    KeptCases kept = KeptCases::None;         ///< whose folders stay
    std::optional<double> most_seconds = {};  ///< of a case, s
    std::optional<double> most_gib = {};      ///< memory of a case, GiB
    std::function<void(const SweepProgress&)> progress = {};  ///< after every case
};

/// What a sweep did.
struct SweepTotals {
    std::uint64_t cases = 0;   ///< rows of the results
    std::uint64_t before = 0;  ///< of these, done by earlier runs
    std::uint64_t failed = 0;  ///< cases with another exit code than 0 and 1
    std::string first_failure =
        {};             ///< number and message of a failed case; may be empty
    double wall_s = 0;  ///< duration of this run, or of the merged ones together
    std::vector<std::string> empty_columns = {};  ///< without a value in any row
};

/// Runs the cases of a plan, each as a process of its own, and writes results.csv with a row
/// for each case in the order of the plan, and sweep.json. Both are written whole at the end;
/// until then the rows are in a journal, with which another run can go on. The results do not
/// depend on jobs, ranks and interruptions, except for times. Folders of cases that are kept
/// move to cases/NNNNNNN.
/// \throws DomainError if the folder has other files, results of another plan or shard, or
///         results of this plan without `resume`;
///         OutputError if another process works in the folder, a process cannot be started,
///         or the disk is full: `resume` goes on afterwards;
///         FormatError if the journal in the folder is none of endmill.
SweepTotals run_sweep(const SweepPlan& plan, const SweepOptions& options,
                      SweepWorkers& workers);

/// Runs the cases that rank 0 hands out, until it ends the work. \pre This is not rank 0.
void serve_sweep(Ranks& ranks);

/// Joins the results of all shards of one plan.
/// \param shards the folders, in any order.
/// \param folder for the results, new or empty unless `full_folder` accepts another.
/// \throws FormatError, LimitError as `read_file`; FormatError for results that endmill did
///         not write; DomainError for shards of different plans or divisions, one that is
///         missing or occurs twice, and one that has not ended; OutputError.
SweepTotals merge_sweeps(std::span<const std::filesystem::path> shards,
                         const std::filesystem::path& folder, FullFolder full_folder);

}  // namespace endmill
