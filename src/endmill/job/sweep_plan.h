// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/files/read_file.h"
#include "endmill/job/program_options.h"

/// \file
/// The plan of a sweep: a command or a job that is run for many cases, each with other values
/// of its parameters. docs/file-formats.md describes the file.

namespace endmill {

/// A value of the summary of a case, for a column of the results.
struct SummaryColumn {
    std::string name;  ///< as in the plan, such as "methods.envelope.trim_ms"
    std::string file;  ///< such as "summary.json" in the folder of the case
    std::vector<std::string> keys;  ///< from the outermost to the innermost
};

/// A plan that was read and checked. An immutable value that is cheap to copy.
class SweepPlan {
public:
    const std::string& name() const;     ///< of the plan, or of its file
    const std::string& source() const;   ///< remark on its origin; may be empty
    const std::string& version() const;  ///< of the program that runs it
    const std::string& command() const;  ///< that every case runs, such as "plan"

    /// SHA-256 of the version of the program, the plan and its list, each ended by a zero
    /// byte. Results of equal hashes belong to the same cases.
    const std::string& sha256() const;

    const std::vector<std::string>& parameters() const;  ///< keys that vary
    const std::vector<SummaryColumn>& columns() const;   ///< values of the results

    std::uint64_t count() const;  ///< number of cases, 1 to 10^7

    /// The values of the parameters of a case, as in the plan. An empty one is not given.
    /// \pre number < count()
    std::vector<std::string> values(std::uint64_t number) const;

    /// The words of the command line of a case, without those that concern the run.
    /// \pre number < count()
    std::vector<std::string> arguments(std::uint64_t number) const;

    /// Whether the plan gives a value to this key.
    bool gives(std::string_view key) const;

private:
    friend SweepPlan parse_sweep_plan(std::string_view content,
                                      const std::filesystem::path& path,
                                      const ProgramDescription& program,
                                      const ReadLimits& limits);
    struct Content;
    explicit SweepPlan(std::shared_ptr<const Content> content);

    std::shared_ptr<const Content> content_;
};

/// A part of the cases of a sweep: every `count`-th, from case `number` - 1 on.
struct SweepShard {
    std::uint64_t number = 1;  ///< 1 to `count`
    std::uint64_t count = 1;   ///< of shards

    /// How many of `cases` cases belong to it.
    std::uint64_t size(std::uint64_t cases) const
    {
        return (cases + count - number) / count;
    }
    /// Its case of index `i`. \pre i < size(cases)
    std::uint64_t at(std::uint64_t i) const { return number - 1 + i * count; }
    std::string text() const;                            ///< such as "2/8"
    bool operator==(const SweepShard&) const = default;  ///< the same cases
};

/// The folders of cases that stay.
enum class KeptCases : std::uint8_t {
    None,    ///< no folder
    Failed,  ///< those of cases that failed
    All,     ///< each folder
};

/// Reads the plan of a sweep, and the list that it names.
/// \param program what its commands accept.
/// \throws FormatError, LimitError as `read_file`; FormatError with the place for a key that
///         is unknown to plans or to the command, a value that the command does not accept
///         as far as that is known without running it (of a job: the first value of each
///         key, and all files), a file that is missing or the plan itself, arrays of an axis of different lengths, more than 10^7 cases, and two
///         columns of the results of one name.
SweepPlan read_sweep_plan(const std::filesystem::path& path,
                          const ProgramDescription& program,
                          const ReadLimits& limits = {});

/// The same for the content of the file.
/// \param path to whose folder the names of files are relative, and for messages.
SweepPlan parse_sweep_plan(std::string_view content, const std::filesystem::path& path,
                           const ProgramDescription& program,
                           const ReadLimits& limits = {});

}  // namespace endmill
