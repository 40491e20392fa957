// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_run.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <csignal>
#include <map>
#include <system_error>
#include <thread>

#include <nlohmann/json.hpp>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/output_folder.h"
#include "endmill/files/read_file.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using nlohmann::json;

constexpr int signal_base = 128;
constexpr int exit_of_output = 5;
constexpr int exit_of_limit = 6;

// The program limits its own memory and reports when there is no more. The hard limit of the
// system lies above by this share and these bytes, for whatever escapes that.
constexpr double share_of_limit = 1.25;
constexpr double spare_bytes = 512 * 0x1p20;
constexpr double one_gib = 0x1p30;

// A batch system that ends a job may signal a case a moment before this process. A row of a
// case that ended by a signal is therefore delayed by this time.
constexpr std::chrono::milliseconds wait_after_signal{500};

// Errors of the disk that concern all cases.
constexpr std::array disk_errors{ENOSPC, EDQUOT, EIO, EROFS, ESTALE};

// What a case writes to its standard error.
struct ErrorLines {
    std::string message;  // of the last error as JSON
    std::string last;     // line of another form

    void add(std::string_view line)
    {
        const json parsed = json::parse(line, nullptr, false);
        if (parsed.is_object() && parsed.contains("error") &&
            parsed["error"].is_object() && parsed["error"].contains("message") &&
            parsed["error"]["message"].is_string())
            message = printable(parsed["error"]["message"].get<std::string>());
        else if (!line.empty())
            last = printable(line);
    }
};

bool is_error_of_disk(const std::string& message)
{
    return std::ranges::any_of(disk_errors, [&](int error) {
        return message.find(std::generic_category().message(error)) != std::string::npos;
    });
}

// Whether a signal ended the case, or the program ended itself because of one.
bool is_interrupted(const ChildResult& result)
{
    constexpr std::array signals{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    return result.end == ChildEnd::Signalled ||
           std::ranges::find(signals, result.code - signal_base) != signals.end();
}

// The exit code and the message of a case that did not end by itself.
void set_end(CaseRow& row, const ChildResult& result, const CaseTask& task,
             const ErrorLines& lines)
{
    row.exit_code = result.code;
    row.message = lines.message;
    if (result.end == ChildEnd::Exited) {
        if (row.is_failed() && row.message.empty())
            row.message = lines.last;
        return;
    }
    if (result.end == ChildEnd::NotStarted) {
        row.message = "the program cannot be started";
        return;
    }
    if (result.end == ChildEnd::OutOfTime && task.most_seconds &&
        result.code == SIGKILL) {
        row.exit_code = exit_of_limit;
        row.message = "ended after " + to_text(*task.most_seconds) +
                      " s; expected less time (--limit-seconds)";
        return;
    }
    row.exit_code = signal_base + result.code;
    row.message = "ended by signal " + std::to_string(result.code);
    if (result.code == SIGKILL)
        row.message += ", as by the system if there is no memory";
    const std::string& said = lines.message.empty() ? lines.last : lines.message;
    if (!said.empty())
        row.message += ": " + said;
}

// A value of a summary as a cell. Arrays, objects and null are none.
std::string cell_of(const json& value)
{
    if (value.is_string())
        return printable(value.get<std::string>());
    if (value.is_number_float())
        return to_text(value.get<double>());
    if (value.is_number() || value.is_boolean())
        return value.dump();
    return "";
}

// The member of an object, or the item of an array; null if there is none.
const json& part_of(const json& value, const std::string& key)
{
    static const json none;
    if (value.is_object() && value.contains(key))
        return value[key];
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    const bool is_index = error == std::errc{} && end == key.data() + key.size();
    return value.is_array() && is_index && index < value.size() ? value[index] : none;
}

// The content of a summary; null if the case has none. One that cannot be read ends the sweep,
// since its row would lack values.
json content_of(const fs::path& file)
{
    std::error_code ignored;
    if (!fs::exists(file, ignored))
        return {};
    return json::parse(read_file(file), nullptr, false);
}

std::vector<std::string> values_of(const CaseTask& task)
{
    std::map<std::string, json> summaries;
    std::vector<std::string> values;
    for (const SummaryColumn& column : task.columns) {
        if (!summaries.contains(column.file))
            summaries[column.file] = content_of(task.folder / column.file);
        const json* value = &summaries[column.file];
        for (const std::string& key : column.keys)
            value = &part_of(*value, key);
        values.push_back(cell_of(*value));
    }
    return values;
}

[[noreturn]] void fail_to(const std::string& act, const fs::path& path,
                          const std::error_code& error)
{
    throw OutputError{"cannot " + act + ' ' + shown_path(path) + ": " + error.message()};
}

// The command line of a case and how it ended, for a person who repeats it.
std::string case_file(const CaseTask& task, const CaseRow& row)
{
    const nlohmann::ordered_json content{{"case", row.number},
                                         {"arguments", task.arguments},
                                         {"exit_code", row.exit_code},
                                         {"message", row.message}};
    return content.dump(2, ' ', false, json::error_handler_t::replace) + '\n';
}

void keep_or_remove(const CaseTask& task, const CaseRow& row)
{
    std::error_code error;
    const bool is_kept = task.kept == KeptCases::All ||
                         (task.kept == KeptCases::Failed && row.is_failed());
    if (!is_kept) {
        fs::remove_all(task.folder, error);
        return;  // the folder of all cases is removed at the end
    }
    write_file(task.folder / "case.json", case_file(task, row));
    fs::create_directories(task.kept_folder.parent_path(), error);
    if (error)
        fail_to("create", task.kept_folder.parent_path(), error);
    fs::remove_all(task.kept_folder, error);  // of a run that was killed
    fs::rename(task.folder, task.kept_folder, error);
    if (error)
        fail_to("create", task.kept_folder, error);
}

ChildTask child_of(const CaseTask& task, ErrorLines& lines)
{
    ChildTask child{.program = task.program, .arguments = task.arguments};
    child.arguments.push_back("--output=" + task.folder.string());
    child.environment = inherited_environment();
    child.limits.wall_seconds = task.most_seconds;
    if (task.most_gib)
        child.limits.data_bytes = share_of_limit * *task.most_gib * one_gib + spare_bytes;
    child.error_line = [&lines](std::string_view line) { lines.add(line); };
    return child;
}

}  // namespace

CaseRow run_case(const CaseTask& task)
{
    ErrorLines lines;
    const auto start = Clock::now();
    const ChildResult result = run_child(child_of(task, lines));
    CaseRow row{.number = task.number,
                .columns = values_of(task),
                .wall_s = std::chrono::duration<double>(Clock::now() - start).count()};
    set_end(row, result, task, lines);
    if (is_interrupted(result))
        std::this_thread::sleep_for(wait_after_signal);
    if (row.exit_code == exit_of_output && is_error_of_disk(row.message))
        throw OutputError{"case " + std::to_string(task.number) + ": " + row.message};
    keep_or_remove(task, row);
    return row;
}

std::string task_line(const CaseTask& task)
{
    json columns = json::array();
    for (const SummaryColumn& column : task.columns)
        columns.push_back({column.name, column.file, column.keys});
    const json line{{"case", task.number},
                    {"program", task.program.string()},
                    {"arguments", task.arguments},
                    {"folder", task.folder.string()},
                    {"kept_folder", task.kept_folder.string()},
                    {"kept", static_cast<int>(task.kept)},
                    {"columns", columns},
                    {"most_seconds", task.most_seconds.value_or(0)},
                    {"most_gib", task.most_gib.value_or(0)}};
    return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

CaseTask task_of_line(std::string_view line)
{
    const json read = json::parse(line);
    const auto limit = [&](const char* key) {
        const double most = read.at(key).get<double>();
        return most > 0 ? std::optional{most} : std::nullopt;
    };
    CaseTask task{.number = read.at("case").get<std::uint64_t>(),
                  .program = read.at("program").get<std::string>(),
                  .arguments = read.at("arguments").get<std::vector<std::string>>(),
                  .folder = read.at("folder").get<std::string>(),
                  .kept_folder = read.at("kept_folder").get<std::string>(),
                  .kept = static_cast<KeptCases>(read.at("kept").get<int>()),
                  .most_seconds = limit("most_seconds"),
                  .most_gib = limit("most_gib")};
    for (const json& column : read.at("columns"))
        task.columns.push_back({column.at(0).get<std::string>(),
                                column.at(1).get<std::string>(),
                                column.at(2).get<std::vector<std::string>>()});
    return task;
}

std::string row_line(const CaseRow& row)
{
    const nlohmann::ordered_json line{{"case", row.number},
                                      {"columns", row.columns},
                                      {"exit_code", row.exit_code},
                                      {"message", row.message},
                                      {"wall_s", row.wall_s}};
    return line.dump(-1, ' ', false, json::error_handler_t::replace);
}

std::optional<CaseRow> row_of_line(std::string_view line)
{
    try {
        const json read = json::parse(line);
        return CaseRow{read.at("case").get<std::uint64_t>(),
                       read.at("columns").get<std::vector<std::string>>(),
                       read.at("exit_code").get<int>(),
                       read.at("message").get<std::string>(),
                       read.at("wall_s").get<double>()};
    } catch (const json::exception&) {
        return std::nullopt;
    }
}

}  // namespace endmill
