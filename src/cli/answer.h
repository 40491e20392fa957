// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace endmill {

/// One line "name = value" for each key of an answer that is not null. A unit at the end of
/// a key, as in "length_mm", follows the value. Numbers are rounded by `shown_result`. An
/// array of objects has a line for each object.
std::string answer_lines(const Json& answer);

/// Prints the answer of a command in the format that `options` ask for. With --output it
/// also writes summary.json.
/// \param inputs files that must not be replaced; empty names are ignored.
/// \throws DomainError, OutputError as `OutputFolder`.
void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer);

/// The same, with another `text` for the terminal than the lines of the answer.
void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer, const std::string& text);

}  // namespace endmill
