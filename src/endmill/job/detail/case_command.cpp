// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/detail/case_command.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>
#include <utility>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"
#include "endmill/job/job_file.h"

namespace endmill {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view input_key = "input";
constexpr std::string_view job_command = "run";
// The command whose input may be a word that describes a machine.
constexpr std::string_view command_of_words = "machine";
// The keys of a job outside of its steps that may name files.
constexpr std::array<std::string_view, 8> files_of_job{
    "part.file", "part.protect", "part.skip_facets", "machine",
    "tool",      "material",     "control",          "stock"};

ProgramCommand command_named(const ProgramDescription& program, std::string_view name)
{
    if (const ProgramCommand* const found = program.find(name))
        return *found;
    return {std::string{name}, {}, true, true};
}

std::string unknown_key(const std::string& key, const std::vector<std::string>& known)
{
    const std::vector<std::string_view> words{known.begin(), known.end()};
    return "unknown key \"" + printable(key, 60) + "\"; expected " + one_of(words, key);
}

// A word that begins with a hyphen would be an option.
std::string no_option(const std::string& word)
{
    return word.starts_with('-') ? "./" + word : word;
}

}  // namespace

std::vector<std::string> sweep_commands(const ProgramDescription& program)
{
    std::vector<std::string> names;
    for (const ProgramCommand& command : program.commands)
        names.push_back(command.name);
    names.emplace_back(job_command);
    return names;
}

CaseCommand::CaseCommand(ProgramDescription program, std::string_view name, fs::path plan)
    : program_{std::move(program)},
      command_{command_named(program_, name)},
      plan_{std::move(plan)},
      base_{plan_.parent_path()}
{
}

void CaseCommand::require_key(const std::string& key) const
{
    if (key == input_key && command_.has_input)
        return;
    if (is_job())
        return require_job_key(key);
    std::vector<std::string> known = command_.keys();
    if (command_.has_input)
        known.emplace_back(input_key);
    if (std::ranges::find(known, key) == known.end())
        throw DomainError{unknown_key(key, known)};
}

// The options of a step are known; the other keys of a job are those of its file.
void CaseCommand::require_job_key(const std::string& key) const
{
    const std::size_t dot = key.find('.');
    const std::string step = key.substr(0, dot);
    if (key.empty() || key.find('=') != std::string::npos)
        throw DomainError{"found the key \"" + printable(key, 60) +
                          "\"; expected a key of a job such as \"plan.scallop\""};
    const ProgramCommand* const command = program_.find(step);
    if (dot == std::string::npos || !command)
        return;
    const std::string option = key.substr(dot + 1);
    std::vector<std::string> known = command->keys();
    std::erase_if(known, is_set_by_run);
    if (std::ranges::find(known, option) == known.end())
        throw DomainError{unknown_key(option, known)};
}

void CaseCommand::require_job(std::span<const KeyValue> given) const
{
    std::vector<JobSetting> settings;
    fs::path file;
    for (const auto& [key, value] : given) {
        if (key == input_key)
            file = input_of(value);
        else
            settings.push_back({key, value});
    }
    const Job job = read_job(file, program_, settings);
    require_other_file(job.part);
    for (const auto& named :
         {job.protect, job.skip_facets, job.material, job.control, job.stock})
        if (named && named->is_file)
            require_other_file(*named->value);
}

bool CaseCommand::checks_values(const std::string& key) const
{
    if (key == input_key && command_.has_input)
        return true;
    return !is_job() && command_.find(key)->value != OptionValue::Text;
}

bool CaseCommand::names_files(const std::string& key) const
{
    if (key == input_key && command_.has_input)
        return true;
    const std::size_t dot = key.find('.');
    const ProgramCommand* const command =
        is_job() ? program_.find(key.substr(0, dot)) : &command_;
    if (is_job() && (dot == std::string::npos || !command))
        return std::ranges::find(files_of_job, key) != files_of_job.end();
    const ProgramOption* const option =
        command->find(is_job() ? key.substr(dot + 1) : key);
    return option && (option->value == OptionValue::File ||
                      option->value == OptionValue::FileOrWord);
}

void CaseCommand::require_other_file(const fs::path& file) const
{
    std::error_code ignored;
    if (fs::equivalent(file, plan_, ignored))
        throw DomainError{"found " + shown_path(file) +
                          ", the plan itself; expected another file"};
}

std::string CaseCommand::input_of(const std::string& text) const
{
    const ProgramOption input{"input", name() == command_of_words
                                           ? OptionValue::FileOrWord
                                           : OptionValue::File};
    return given_option(input, text, base_)->value.value();
}

void CaseCommand::require_value(const KeyValue& given) const
{
    if (given.key == input_key && command_.has_input)
        return require_other_file(input_of(given.value));
    if (is_job())
        return;
    const auto option = given_option(*command_.find(given.key), given.value, base_);
    if (option && option->is_file)
        require_other_file(*option->value);
}

std::vector<std::string> CaseCommand::arguments(std::span<const KeyValue> given) const
{
    std::vector<std::string> words{name()};
    std::vector<GivenOption> options;
    for (const auto& [key, value] : given) {
        if (key == input_key && command_.has_input)
            words.push_back(no_option(input_of(value)));
        else if (is_job())
            options.push_back({"--set", std::string{key}.append("=").append(value)});
        else if (auto option = given_option(*command_.find(key), value, base_))
            options.push_back(*std::move(option));
    }
    const std::vector<std::string> more = arguments_of(options);
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

}  // namespace endmill
