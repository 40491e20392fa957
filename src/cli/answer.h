// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/command.h"

namespace endmill {

/// The keys of an answer, a line each: "key = value".
std::string answer_lines(const Json& answer);

/// What a command does that only answers: prints it as asked, and writes it to summary.json
/// with --output.
/// \param inputs files that must not be replaced; an empty name is none.
/// \throws DomainError, OutputError as `OutputFolder`.
void give_answer(const CommonOptions& options, const std::vector<std::string>& inputs,
                 const Json& answer);

}  // namespace endmill
