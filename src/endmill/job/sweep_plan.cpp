// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/sweep_plan.h"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "endmill/core/text.h"
#include "endmill/files/detail/json_format.h"
#include "endmill/files/path_file.h"
#include "endmill/job/detail/case_command.h"
#include "endmill/job/detail/case_values.h"
#include "endmill/job/job_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view format_name = "endmill-sweep/1";
constexpr const char* summary_name = "summary.json";

// The columns of the results that every sweep has.
constexpr std::array<std::string_view, 4> columns_of_all{"case", "exit_code", "message",
                                                         "wall_s"};
// The forms in which a plan may give its cases.
constexpr std::array<std::string_view, 3> forms{"grid", "list", "random"};

fs::path beside(const fs::path& plan, const std::string& name)
{
    return (plan.parent_path() / name).lexically_normal();
}

std::string content_of_list(const JsonValue& list, const fs::path& plan,
                            const ReadLimits& limits)
{
    const fs::path file = beside(plan, checked_argument(list));
    std::error_code ignored;
    if (fs::equivalent(file, plan, ignored))
        throw list.complaint(list.shown() + ", the plan itself", "a CSV file");
    return read_file(file, limits);
}

std::vector<std::string> parts_of(std::string_view path)
{
    std::vector<std::string> parts;
    while (true) {
        const std::size_t dot = std::min(path.find('.'), path.size());
        parts.emplace_back(path.substr(0, dot));
        if (dot == path.size())
            return parts;
        path.remove_prefix(dot + 1);
    }
}

// The folder of a step in the results of a job.
std::string folder_of_step(const JsonValue& column, const std::string& step)
{
    const auto* const found = std::ranges::find(job_step_names, step);
    if (found == job_step_names.end())
        throw column.complaint(
            column.shown(),
            "a step and a key of its summary, such as \"plan.tcd_mm\"; "
            "the steps are " +
                one_of(job_step_names, step));
    return '0' + std::to_string(found - job_step_names.begin() + 1) + '-' + step + '/';
}

SummaryColumn column_of(const JsonValue& column, const CaseCommand& command)
{
    SummaryColumn made{checked_argument(column), summary_name,
                       parts_of(checked_argument(column))};
    if (command.is_job()) {
        made.file = folder_of_step(column, made.keys.front()) + summary_name;
        made.keys.erase(made.keys.begin());
    }
    if (made.keys.empty() || std::ranges::find(made.keys, "") != made.keys.end())
        throw column.complaint(column.shown(), "keys of a summary with dots between");
    return made;
}

std::vector<SummaryColumn> columns_of(const JsonValue& columns,
                                      std::vector<std::string> taken,
                                      const CaseCommand& command)
{
    taken.insert(taken.end(), columns_of_all.begin(), columns_of_all.end());
    std::vector<SummaryColumn> all;
    for (std::size_t i = 0; i < columns.size(); ++i) {
        const JsonValue column = columns.item(i);
        all.push_back(column_of(column, command));
        if (std::ranges::find(taken, all.back().name) != taken.end())
            throw column.complaint(
                column.shown() + ", which is the name of another column of results.csv",
                "another key of the summary");
        taken.push_back(all.back().name);
    }
    return all;
}

// Adds a value that is the same for all cases.
void add_fixed(std::vector<KeyValue>& fixed, const std::string& key,
               const JsonValue& value, const CaseCommand& command)
{
    fixed.push_back({key, checked_argument(value)});
    try {
        command.require_key(key);
        command.require_value(fixed.back());
    } catch (const DomainError& error) {
        throw value.complaint(error.what(), "");
    }
}

std::vector<KeyValue> fixed_of(const JsonValue& root, const CaseCommand& command)
{
    std::vector<KeyValue> fixed;
    if (const auto input = root.find_member("input"))
        add_fixed(fixed, "input", *input, command);
    const auto options = root.find_member("options");
    if (!options)
        return fixed;
    for (const std::string_view key : options->keys()) {
        const JsonValue value = options->member(key);
        if (key == "input")
            throw value.complaint("unknown key", "input outside of options");
        add_fixed(fixed, std::string{key}, value, command);
    }
    return fixed;
}

std::string_view form_of(const JsonValue& root)
{
    std::vector<std::string_view> found;
    for (const std::string_view form : forms)
        if (root.find_member(form))
            found.push_back(form);
    if (found.size() == 1)
        return found.front();
    const std::string shown = found.empty() ? "none of the keys grid, list and random"
                                            : "the keys " + std::string{found[0]} +
                                                  " and " + std::string{found[1]};
    throw root.complaint(shown, "exactly one of grid, list and random");
}

}  // namespace

struct SweepPlan::Content {
    std::string name;
    std::string source;
    std::string version;
    std::string sha256;
    CaseCommand command;
    std::vector<KeyValue> fixed;
    CaseValues values;
    std::vector<std::string> parameters;
    std::vector<SummaryColumn> columns;

    // All that a case gives to the command.
    std::vector<KeyValue> given(const std::vector<std::string>& varied) const
    {
        std::vector<KeyValue> all = fixed;
        for (std::size_t i = 0; i < varied.size(); ++i)
            if (!varied[i].empty())
                all.push_back({parameters[i], varied[i]});
        return all;
    }
};

namespace {

CaseValues values_of(const JsonValue& root, std::string_view form, const fs::path& path,
                     const CaseCommand& command, std::string list)
{
    const JsonValue cases = root.member(form);
    if (form == "grid")
        return CaseGrid{cases, command};
    if (form == "list")
        return CaseList{std::move(list), beside(path, cases.text()), command};
    return CaseSamples{cases, command};
}

std::vector<std::string> keys_of(const CaseValues& values)
{
    return std::visit([](const auto& cases) { return cases.keys(); }, values);
}

void require_no_key_twice(const JsonValue& root, std::span<const KeyValue> fixed,
                          std::span<const std::string> parameters)
{
    for (const KeyValue& given : fixed)
        if (std::ranges::find(parameters, given.key) != parameters.end())
            throw root.complaint(
                "key \"" + given.key + "\" has one value for all cases and varies too",
                "only one of them");
}

// The cases of a sweep over a job that show whether the job has all keys and files: the first
// with a value of each parameter, and the first with each value of one that names files.
class TellingCases {
public:
    TellingCases(const std::vector<std::string>& keys, const CaseCommand& command)
        : seen_(keys.size())
    {
        for (const std::string& key : keys)
            names_files_.push_back(command.names_files(key));
    }

    // Whether a case has a value that the cases before do not stand for.
    bool adds(const std::vector<std::string>& values)
    {
        bool is_new = false;
        for (std::size_t i = 0; i < values.size(); ++i)
            if (!values[i].empty() && (seen_[i].empty() || names_files_[i]))
                is_new |= seen_[i].insert(values[i]).second;
        return is_new;
    }

    // Whether no further case can add a value.
    bool is_complete() const
    {
        return std::ranges::none_of(names_files_, std::identity{}) &&
               std::ranges::none_of(seen_, [](const auto& seen) { return seen.empty(); });
    }

private:
    std::vector<bool> names_files_;            // for each parameter
    std::vector<std::set<std::string>> seen_;  // values of each parameter
};

// Whether a key is the other one or leads to it, as "plan" leads to "plan.scallop".
bool leads_to(const std::string& key, const std::string& other)
{
    return other == key || other.starts_with(key + '.');
}

// An error of the job of a case as one of the plan. If the plan gives the key in question, the
// message names it in place of the file of the job, which does not have it.
FormatError job_complaint(const JsonValue& root, std::uint64_t number, const Error& error,
                          std::span<const KeyValue> given)
{
    const std::string label = "case " + std::to_string(number) + ": ";
    const std::string message = error.what();
    const auto* const in_file = dynamic_cast<const FormatError*>(&error);
    if (!in_file || !in_file->place().starts_with('/'))
        return root.complaint(label + message, "");
    std::string key = in_file->place().substr(1);
    std::ranges::replace(key, '/', '.');
    const std::string begin = in_file->file() + ':' + in_file->place() + ": ";
    const bool is_given = std::ranges::any_of(given, [&](const KeyValue& one) {
        return leads_to(key, one.key) || leads_to(one.key, key);
    });
    if (!is_given || !message.starts_with(begin))
        return root.complaint(label + message, "");
    return root.complaint(label + key + ": " + message.substr(begin.size()), "");
}

// Reads the job of case 0 and of the other telling cases.
void require_jobs(const JsonValue& root, const CaseCommand& command,
                  const SweepPlan& plan,
                  const std::function<std::vector<KeyValue>(std::uint64_t)>& given_of)
{
    TellingCases telling{plan.parameters(), command};
    for (std::uint64_t number = 0; number < plan.count() && !telling.is_complete();
         ++number) {
        if (!telling.adds(plan.values(number)) && number > 0)
            continue;
        const std::vector<KeyValue> given = given_of(number);
        try {
            command.require_job(given);
        } catch (const DomainError& error) {
            throw job_complaint(root, number, error, given);
        } catch (const FormatError& error) {
            throw job_complaint(root, number, error, given);
        }
    }
}

std::string hash_of(std::string_view version, std::string_view plan,
                    std::string_view list)
{
    ContentSha256 hash;
    for (const std::string_view piece : {version, plan, list}) {
        hash.add(piece);
        hash.add(std::string_view{"\0", 1});
    }
    return hash.word();
}

}  // namespace

SweepPlan::SweepPlan(std::shared_ptr<const Content> content)
    : content_{std::move(content)}
{
}

SweepPlan parse_sweep_plan(std::string_view content, const fs::path& path,
                           const ProgramDescription& program, const ReadLimits& limits)
{
    constexpr std::array<std::string_view, 10> keys{
        "format",  "name", "source", "command", "input",
        "options", "grid", "list",   "random",  "columns"};
    const FormatDocument document{content, path, limits, format_name};
    const JsonValue root = document.root();
    root.allow_only(keys);

    const std::vector<std::string> commands = sweep_commands(program);
    const std::vector<std::string_view> words{commands.begin(), commands.end()};
    const JsonValue command_word = root.member("command");
    const CaseCommand command{program, command_word.word(words), path};
    std::vector<KeyValue> fixed = fixed_of(root, command);
    const std::string_view form = form_of(root);
    const JsonValue cases = root.member(form);
    std::string list =
        form == "list" ? content_of_list(cases, path, limits) : std::string{};
    std::string hash = hash_of(program.version, content, list);
    CaseValues values = values_of(root, form, path, command, std::move(list));
    std::vector<std::string> parameters = keys_of(values);
    require_no_key_twice(root, fixed, parameters);
    const auto columns = root.find_member("columns");
    std::vector<SummaryColumn> chosen = columns
                                            ? columns_of(*columns, parameters, command)
                                            : std::vector<SummaryColumn>{};
    SweepPlan plan{std::make_shared<const SweepPlan::Content>(
        SweepPlan::Content{name_or_stem(root, path), remark(root, "source"),
                           program.version, std::move(hash), command, std::move(fixed),
                           std::move(values), std::move(parameters), std::move(chosen)})};
    if (command.needs_input() && !plan.gives("input"))
        throw root.complaint("no input",
                             "the key input with a file, or a parameter input");
    if (command.is_job())
        require_jobs(root, command, plan, [&](std::uint64_t number) {
            return plan.content_->given(plan.values(number));
        });
    return plan;
}

SweepPlan read_sweep_plan(const fs::path& path, const ProgramDescription& program,
                          const ReadLimits& limits)
{
    return parse_sweep_plan(read_file(path, limits), path, program, limits);
}

std::string SweepShard::text() const
{
    return std::to_string(number) + '/' + std::to_string(count);
}

const std::string& SweepPlan::name() const
{
    return content_->name;
}

const std::string& SweepPlan::source() const
{
    return content_->source;
}

const std::string& SweepPlan::version() const
{
    return content_->version;
}

const std::string& SweepPlan::command() const
{
    return content_->command.name();
}

const std::string& SweepPlan::sha256() const
{
    return content_->sha256;
}

const std::vector<std::string>& SweepPlan::parameters() const
{
    return content_->parameters;
}

const std::vector<SummaryColumn>& SweepPlan::columns() const
{
    return content_->columns;
}

std::uint64_t SweepPlan::count() const
{
    return std::visit([](const auto& cases) { return cases.count(); }, content_->values);
}

std::vector<std::string> SweepPlan::values(std::uint64_t number) const
{
    return std::visit([&](const auto& cases) { return cases.values(number); },
                      content_->values);
}

std::vector<std::string> SweepPlan::arguments(std::uint64_t number) const
{
    return content_->command.arguments(content_->given(values(number)));
}

bool SweepPlan::gives(std::string_view key) const
{
    return std::ranges::find(parameters(), key) != parameters().end() ||
           std::ranges::find(content_->fixed, key, &KeyValue::key) !=
               content_->fixed.end();
}

}  // namespace endmill
