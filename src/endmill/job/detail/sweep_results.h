// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/output_folder.h"
#include "endmill/job/detail/sweep_journal.h"

/// \file
/// The files of a sweep that has ended: results.csv and sweep.json.

namespace endmill {

inline constexpr const char* results_file = "results.csv";  ///< a row for each case
inline constexpr const char* sweep_file = "sweep.json";     ///< what they belong to

/// The content of sweep.json.
struct SweepFacts {
    SweepIdentity identity;    ///< plan and shard
    std::string version;       ///< of the program
    std::string name;          ///< of the plan
    std::string source;        ///< of the plan
    std::string command;       ///< that each case ran
    std::uint64_t failed = 0;  ///< cases
    double wall_s = 0;         ///< duration
};

/// The text of sweep.json.
std::string sweep_text(const SweepFacts& facts);

/// Reads sweep.json in a folder. \return nothing if there is none.
/// \throws FormatError, LimitError as `read_file`; FormatError unless endmill wrote it.
std::optional<SweepFacts> read_sweep_facts(const std::filesystem::path& folder);

/// A line of a CSV file with its end. Cells are quoted as in RFC 4180 where they need it.
std::string csv_line(std::span<const std::string> cells);

/// Writes both files, or none.
/// \param rows passes all lines of results.csv to its sink.
/// \throws as `OutputFolder`.
void write_results(const std::filesystem::path& folder, FullFolder full_folder,
                   const SweepFacts& facts,
                   const std::function<void(const OutputFolder::Sink&)>& rows);

}  // namespace endmill
