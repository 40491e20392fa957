// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "endmill/job/program_options.h"

namespace endmill {

/// A key with the value that a plan gives to it.
struct KeyValue {
    std::string key;    ///< of an option or a job, or "input"
    std::string value;  ///< as on the command line
};

/// The names of the commands that a sweep may run.
std::vector<std::string> sweep_commands(const ProgramDescription& program);

/// What a sweep runs: a command of the program, or `run` with a job.
class CaseCommand {
public:
    /// \param name one of `sweep_commands`.
    /// \param plan the file of the plan, to whose folder the names of files are relative.
    CaseCommand(ProgramDescription program, std::string_view name,
                std::filesystem::path plan);

    const std::string& name() const { return command_.name; }  ///< such as "plan"
    bool is_job() const { return name() == "run"; }            ///< whether it runs a job
    /// Whether it cannot run without an input.
    bool needs_input() const { return command_.needs_input; }

    /// Reads a job with the settings of a case, for what only the reader of jobs knows.
    /// \throws as `read_job`; DomainError if it names the plan. \pre is_job()
    void require_job(std::span<const KeyValue> given) const;

    /// Checks that the command knows a key.
    /// \throws DomainError with a suggestion.
    void require_key(const std::string& key) const;

    /// Whether values of this key can be checked without the command: those of an option that
    /// takes none, or that names files. \pre The key is known.
    bool checks_values(const std::string& key) const;

    /// Whether values of this key may be names of files. \pre The key is known.
    bool names_files(const std::string& key) const;

    /// Checks as much of a value as is known without the command: files exist and are not the
    /// plan itself, and an option that takes no value has true or false.
    /// \throws DomainError. \pre The key is known.
    void require_value(const KeyValue& given) const;

    /// The words of the command line: the command, its input and its options in the order
    /// given. \pre All keys and values were checked.
    std::vector<std::string> arguments(std::span<const KeyValue> given) const;

private:
    void require_job_key(const std::string& key) const;
    std::string input_of(const std::string& text) const;
    void require_other_file(const std::filesystem::path& file) const;

    ProgramDescription program_;
    ProgramCommand command_;
    std::filesystem::path plan_;
    std::filesystem::path base_;
};

}  // namespace endmill
