// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace endmill {

/// One line "key = value" for each key of an answer. Numbers are rounded by `shown`.
std::string answer_lines(const Json& answer);

/// Prints the answer of a command in the format that `options` ask for. With --output it
/// also writes summary.json.
/// \param inputs files that must not be replaced; empty names are ignored.
/// \throws DomainError, OutputError as `OutputFolder`.
void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer);

}  // namespace endmill
