// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/console.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <new>

#include "cli/memory_limit.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

void write_error(const Json& error, ExitCode exit, bool as_json)
{
    Json whole = error;
    whole["exit"] = static_cast<int>(exit);
    const std::string line =
        as_json
            ? Json{{"error", whole}}.dump(-1, ' ', false, Json::error_handler_t::replace)
            : "endmill: error: " + error["message"].get<std::string>();
    std::fprintf(stderr, "%s\n", line.c_str());
}

}  // namespace

void print(const std::string& text)
{
    const bool is_written =
        std::fwrite(text.data(), 1, text.size(), stdout) == text.size() &&
        std::fflush(stdout) == 0;
    if (!is_written)
        throw OutputError{"cannot write to standard output: " +
                          std::string{std::strerror(errno)}};
}

void warn(const CommonOptions& options, const std::string& text)
{
    if (!options.quiet)
        std::fprintf(stderr, "endmill: warning: %s\n", printable(text).c_str());
}

void print_result(const CommonOptions& options, const Json& summary,
                  const std::string& text)
{
    if (options.json)
        print(summary.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
    else if (!options.quiet)
        print(text);
}

void report_error(const std::string& code, const std::string& message, ExitCode exit,
                  bool as_json)
{
    write_error({{"code", code}, {"message", printable(message)}}, exit, as_json);
}

namespace {

ExitCode report_exception(bool as_json)
{
    const auto report = [&](const Error& error, ExitCode exit) {
        report_error(error.code(), error.what(), exit, as_json);
        return exit;
    };
    try {
        throw;
    } catch (const FormatError& error) {
        write_error({{"code", error.code()},
                     {"message", printable(error.what())},
                     {"file", printable(error.file())},
                     {"place", printable(error.place())}},
                    ExitCode::Input, as_json);
        return ExitCode::Input;
    } catch (const DomainError& error) {
        return report(error, ExitCode::Usage);
    } catch (const GeometryError& error) {
        return report(error, ExitCode::Geometry);
    } catch (const OutputError& error) {
        return report(error, ExitCode::Output);
    } catch (const LimitError& error) {
        return report(error, ExitCode::Limit);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {
        report_error("E_FAULT",
                     std::string{"this is a fault of endmill; please report it with the "
                                 "command line and the input: "} +
                         error.what(),
                     ExitCode::Fault, as_json);
        return ExitCode::Fault;
    }
}

}  // namespace

void report_lack_of_memory(bool as_json) noexcept
{
    std::fputs(lack_of_memory_message(as_json), stderr);
}

ExitCode report_current_exception(bool as_json) noexcept
{
    try {
        return report_exception(as_json);
    } catch (...) {
        report_lack_of_memory(as_json);
        return ExitCode::Limit;
    }
}

Json finite_or_null(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace endmill
