// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

namespace endmill {

/// Whether an unknown word stands where a command was expected, which CLI11 overlooks when
/// help is asked for.
bool names_unknown_command(const CLI::App& program);

/// What is wrong with the command line that `program` parsed until `error`: the word that
/// is not known, with what was probably meant, or the error's own words.
std::string usage_message(const CLI::App& program, const CLI::ParseError& error);

/// Of the first option or argument that was given an empty text, for which no command has a
/// use: most often it is a shell's variable that is not set. Nothing if there is none.
std::optional<std::string> empty_text_message(const CLI::App& program);

}  // namespace endmill
