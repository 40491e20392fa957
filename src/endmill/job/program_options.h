// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// \file
/// What the commands of the program accept, as far as jobs and sweeps need it: the keys of a
/// job are the names of options, so that each option of a command is also one of its step.

namespace endmill {

/// What an option takes.
enum class OptionValue {
    None,        ///< nothing: the option is given or not
    Text,        ///< a number, a word or a list
    File,        ///< the name of a file, or the word none
    FileOrWord,  ///< the name of a file, or a word with another meaning
};

/// An option of a command.
struct ProgramOption {
    std::string name;   ///< such as "--chord-tolerance"
    OptionValue value;  ///< what it takes
    /// The words that it takes in place of a file, or, if it takes a text, the only ones.
    /// Empty: any text.
    std::vector<std::string> words = {};

    std::string key() const;  ///< such as "chord_tolerance"
};

/// A command of the program.
struct ProgramCommand {
    std::string name;                    ///< such as "plan"
    std::vector<ProgramOption> options;  ///< in the order of the help
    bool has_input = true;               ///< whether it takes a file without an option
    bool needs_input = false;            ///< whether it cannot run without that file

    /// The option with this key. \return nothing if there is none.
    const ProgramOption* find(std::string_view key) const;

    /// The keys of all options.
    std::vector<std::string> keys() const;
};

/// What the program accepts, and how it is started.
struct ProgramDescription {
    std::filesystem::path program;         ///< absolute path
    std::string version;                   ///< of the program
    std::vector<ProgramCommand> commands;  ///< without those of jobs

    /// The command of this name. \return nothing if there is none.
    const ProgramCommand* find(std::string_view name) const;
};

/// An option that a step or a case gives to a command.
struct GivenOption {
    std::string name;                       ///< such as "--chord-tolerance"
    std::optional<std::string> value = {};  ///< nothing for an option that takes none
    bool is_file = false;                   ///< whether `value` is the name of a file
};

/// The option of a key with the value that a job or a plan gives.
/// \param option of a command.
/// \param text as on the command line; "true" gives an option that takes no value, "false"
///        does not.
/// \param base folder to which the name of a file is relative. The value is then the path
///        from the current folder.
/// \return nothing for the text "false" of an option that takes no value.
/// \throws DomainError if an option that takes no value gets another text, for a word that the
///         option does not know, or if a file is missing.
std::optional<GivenOption> given_option(const ProgramOption& option,
                                        const std::string& text,
                                        const std::filesystem::path& base);

/// Adds an option unless one of its name is given already.
void add_default(std::vector<GivenOption>& given, GivenOption option);

/// Whether an option of this name is given.
bool is_given(std::span<const GivenOption> given, std::string_view name);

/// The words of the command line, such as "--scallop=0.1".
std::vector<std::string> arguments_of(std::span<const GivenOption> given);

}  // namespace endmill
