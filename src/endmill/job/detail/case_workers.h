// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "endmill/job/detail/case_run.h"
#include "endmill/job/ranks.h"
#include "endmill/job/sweep_workers.h"

namespace endmill {

/// Runs the cases that rank 0 hands out by its SweepWorkers, until it ends the work.
/// \pre This is not rank 0.
void serve_cases(Ranks& ranks);

/// Where cases come from and rows go. One thread at a time calls the functions.
struct CaseTraffic {
    std::function<std::optional<CaseTask>()> next;   ///< nothing: no case is left
    std::function<void(const CaseRow& row)> record;  ///< of a case that ended
};

/// Runs all cases on this rank, `jobs` at a time, and on the workers, one at a time each.
/// After an error no further case begins; those that run are waited for.
/// \throws the first error of `next`, `record` and `run_case`; OutputError with the message
///         of a worker.
void run_cases(const CaseTraffic& traffic, int jobs, SweepWorkers& workers);

}  // namespace endmill
