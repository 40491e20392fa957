// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <string>

#include "cli/command.h"
#include "endmill/core/error.h"

namespace endmill {

/// Writes all of `text` to standard output. \throws OutputError if the write fails.
void print(const std::string& text);

/// Writes "endmill: warning: TEXT" to standard error, unless --quiet.
void warn(const CommonOptions& options, const std::string& text);

/// Prints `summary` with --json, nothing with --quiet, and `text` otherwise.
void print_result(const CommonOptions& options, const Json& summary,
                  const std::string& text);

/// Calls `act` and returns its result. A GeometryError gets the prefix `file`.
template <typename Act>
auto naming(const std::string& file, Act act)
{
    try {
        return act();
    } catch (const GeometryError& error) {
        throw GeometryError{file + ": " + error.what()};
    }
}

/// Reports the current exception on standard error, as the line "endmill: error: …" or
/// as a JSON object. If there is no memory for the report, or the exception says so, it
/// reports that.
/// \return the exit code of the program.
ExitCode report_current_exception(bool as_json) noexcept;

/// Reports in the same format that there is no memory. It needs none.
void report_lack_of_memory(bool as_json) noexcept;

/// Reports `message` in the same format.
void report_error(const std::string& code, const std::string& message, ExitCode exit,
                  bool as_json);

/// `value`, or null if it is not finite.
Json finite_or_null(double value);

}  // namespace endmill
