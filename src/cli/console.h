// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "cli/command.h"
#include "endmill/core/error.h"

namespace endmill {

/// Writes `text` to standard output, whole. \throws OutputError if that fails.
void print(const std::string& text);

/// Writes "endmill: warning: TEXT" to standard error, unless --quiet.
void warn(const CommonOptions& options, const std::string& text);

/// Prints the result as asked: `summary` with --json, else `text`, nothing with --quiet.
void print_result(const CommonOptions& options, const Json& summary,
                  const std::string& text);

/// What `act` returns. A GeometryError that it throws is made to name `file`.
template <typename Act>
auto naming(const std::string& file, Act act)
{
    try {
        return act();
    } catch (const GeometryError& error) {
        throw GeometryError{file + ": " + error.what()};
    }
}

/// Writes the one line "endmill: error: …" (or a JSON object) for the exception in flight
/// to standard error.
/// \return what the program exits with.
ExitCode report_current_exception(bool as_json);

/// The same for a message that is no exception.
void report_error(const std::string& code, const std::string& message, ExitCode exit,
                  bool as_json);

/// `value`, or null if it is not finite.
Json finite_or_null(double value);

}  // namespace endmill
