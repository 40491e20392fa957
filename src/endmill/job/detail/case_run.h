// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/job/sweep_plan.h"

/// \file
/// One case of a sweep: the run of the program in a process of its own, and the row of the
/// results that it gives. Both travel between processes as one line of JSON.

namespace endmill {

/// A case to run.
struct CaseTask {
    std::uint64_t number = 0;                 ///< of the case, from 0
    std::filesystem::path program = {};       ///< absolute path
    std::vector<std::string> arguments = {};  ///< without the folder of the results
    std::filesystem::path folder = {};        ///< for the results; does not exist yet
    std::filesystem::path kept_folder = {};   ///< to which it moves if it is kept
    KeptCases kept = KeptCases::None;         ///< whether it is kept
    std::vector<SummaryColumn> columns = {};  ///< values to read from the results
    std::optional<double> most_seconds = {};  ///< until the case is ended
    std::optional<double> most_gib = {};      ///< of memory
};

/// The row of a case in the results.
struct CaseRow {
    std::uint64_t number = 0;               ///< of the case, from 0
    std::vector<std::string> columns = {};  ///< a text for each column; empty if unknown
    int exit_code = 0;         ///< of the program; 128 and more: ended by a signal
    std::string message = {};  ///< its error; empty without one
    double wall_s = 0;         ///< duration of the process, s

    /// Whether it gave no result: exit codes 0 and 1 answer yes and no.
    bool is_failed() const { return exit_code > 1; }
    bool operator==(const CaseRow&) const = default;  ///< equal in all members
};

/// Runs a case, keeps or removes its folder, and returns its row. A case that fails is a row
/// too.
/// \throws OutputError if the process cannot be started, or if the disk is full or fails: all
///         other cases would fail too.
CaseRow run_case(const CaseTask& task);

std::string task_line(const CaseTask& task);   ///< without a line feed
CaseTask task_of_line(std::string_view line);  ///< \pre made by `task_line`
std::string row_line(const CaseRow& row);      ///< without a line feed

/// The row of a line. \return nothing if the line was not made by `row_line`.
std::optional<CaseRow> row_of_line(std::string_view line);

}  // namespace endmill
