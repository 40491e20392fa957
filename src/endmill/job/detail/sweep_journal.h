// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "endmill/job/detail/case_run.h"

namespace endmill {

/// What the results in a folder belong to.
struct SweepIdentity {
    std::string plan_sha256;                                ///< as SweepPlan::sha256
    std::uint64_t cases = 0;                                ///< of the whole plan
    SweepShard shard = {};                                  ///< that the folder has
    bool operator==(const SweepIdentity&) const = default;  ///< the same cases
};

/// The rows of the cases that have ended, in a file that only grows. Every row is in the file
/// before the next case is chosen. If the process is killed, a last line that is not complete
/// does not count. Rows are kept in the file and not in memory.
class SweepJournal {
public:
    /// The identity in the first line of a journal.
    /// \return nothing if there is no file, or if its first line is not complete.
    /// \throws FormatError if the first line is another one; LimitError, FormatError as
    ///         `read_file`, except that the file may be missing or empty.
    static std::optional<SweepIdentity> identity_in(const std::filesystem::path& file);

    /// Opens or creates the file.
    /// \throws FormatError with the line for one that is no row of a case of the shard;
    ///         OutputError if the file cannot be written.
    SweepJournal(std::filesystem::path file, const SweepIdentity& identity);
    ~SweepJournal();                                        ///< closes the file
    SweepJournal(const SweepJournal&) = delete;             ///< one file, one owner
    SweepJournal& operator=(const SweepJournal&) = delete;  ///< not assignable either

    std::uint64_t count() const { return count_; }    ///< number of rows
    std::uint64_t failed() const { return failed_; }  ///< number of failed cases

    /// Whether the case of index `i` in the shard has ended.
    bool has(std::uint64_t i) const { return ends_[i] != 0; }

    /// Adds the row of a case of the shard.
    /// \throws OutputError if it cannot be written; the file is then as before.
    void append(const CaseRow& row);

    /// The row of the case of index `i` in the shard. \pre has(i)
    CaseRow row(std::uint64_t i) const;

    /// Flushes the rows to the disk. \throws OutputError
    void flush();

private:
    void read_rows();
    void add(const CaseRow& row, std::uint64_t line_begin, std::uint64_t line_end);
    void write(const std::string& line);

    std::filesystem::path file_;
    SweepIdentity identity_;
    int descriptor_ = -1;
    std::uint64_t size_ = 0;             // of the complete lines
    std::vector<std::uint64_t> begins_;  // of the line of each case of the shard
    std::vector<std::uint64_t> ends_;    // 0: it has not ended
    std::uint64_t count_ = 0;
    std::uint64_t failed_ = 0;
    std::chrono::steady_clock::time_point flushed_ = std::chrono::steady_clock::now();
};

}  // namespace endmill
