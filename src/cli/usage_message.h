// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace endmill {

/// Whether the command line has an unknown word in place of a command. CLI11 does not
/// report it together with --help.
bool names_unknown_command(const CLI::App& program);

/// The message for the parse error `error`. It names an unknown word with the most
/// similar known word, or repeats the message of the error.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error);

/// The message for the first option or argument with an empty text, or nothing if there
/// is none. No command accepts an empty text; it usually comes from an unset shell
/// variable.
std::optional<std::string> empty_text_message(const CLI::App& program);

}  // namespace endmill
