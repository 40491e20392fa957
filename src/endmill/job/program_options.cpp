// SPDX-License-Identifier: GPL-3.0-or-later
#include "endmill/job/program_options.h"

#include <algorithm>
#include <system_error>

#include "endmill/core/error.h"
#include "endmill/core/text.h"
#include "endmill/files/read_file.h"

namespace endmill {

namespace fs = std::filesystem;

namespace {

void require_word(const ProgramOption& option, const std::string& text)
{
    if (option.words.empty() ||
        std::ranges::find(option.words, text) != option.words.end())
        return;
    const std::vector<std::string_view> words{option.words.begin(), option.words.end()};
    throw DomainError{
        "found \"" + printable(text, 60) + "\"; expected " +
        (option.value == OptionValue::FileOrWord ? "an existing file, " : "") +
        one_of(words, text)};
}

}  // namespace

std::string ProgramOption::key() const
{
    std::string key = name.substr(name.find_first_not_of('-'));
    std::ranges::replace(key, '-', '_');
    return key;
}

const ProgramOption* ProgramCommand::find(std::string_view key) const
{
    const auto found = std::ranges::find(options, key, &ProgramOption::key);
    return found == options.end() ? nullptr : &*found;
}

std::vector<std::string> ProgramCommand::keys() const
{
    std::vector<std::string> all;
    for (const ProgramOption& option : options)
        all.push_back(option.key());
    return all;
}

const ProgramCommand* ProgramDescription::find(std::string_view name) const
{
    const auto found = std::ranges::find(commands, name, &ProgramCommand::name);
    return found == commands.end() ? nullptr : &*found;
}

std::optional<GivenOption> given_option(const ProgramOption& option,
                                        const std::string& text, const fs::path& base)
{
    if (option.value == OptionValue::None) {
        if (text == "true")
            return GivenOption{option.name};
        if (text == "false")
            return std::nullopt;
        throw DomainError{"found " + printable(text, 60) + "; expected true or false"};
    }
    if (option.value == OptionValue::Text) {
        require_word(option, text);
        return GivenOption{option.name, text};
    }
    std::error_code ignored;
    const fs::path file = (base / text).lexically_normal();
    if (!text.empty() && fs::is_regular_file(file, ignored))
        return GivenOption{option.name, file.string(), true};
    if (option.value == OptionValue::File && text != "none")
        throw DomainError{"found " + (text.empty() ? "an empty name" : shown_path(file)) +
                          (fs::exists(file, ignored) ? ", which is no file"
                                                     : ", which does not exist") +
                          "; expected a file"};
    if (option.value == OptionValue::FileOrWord)
        require_word(option, text);
    return GivenOption{option.name, text};
}

void add_default(std::vector<GivenOption>& given, GivenOption option)
{
    if (!is_given(given, option.name))
        given.push_back(std::move(option));
}

bool is_given(std::span<const GivenOption> given, std::string_view name)
{
    return std::ranges::find(given, name, &GivenOption::name) != given.end();
}

std::vector<std::string> arguments_of(std::span<const GivenOption> given)
{
    std::vector<std::string> words;
    for (const GivenOption& option : given)
        words.push_back(option.value ? option.name + '=' + *option.value : option.name);
    return words;
}

}  // namespace endmill
