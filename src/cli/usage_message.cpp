// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/usage_message.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include "endmill/core/text.h"

namespace endmill {
namespace {

const CLI::App& chosen_command(const CLI::App& program)
{
    const CLI::App* command = &program;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().front();
    return *command;
}

// The name of a command with its parents, such as "endmill eval path-interval".
std::string full_name(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

std::vector<const CLI::App*> subcommands(const CLI::App& command)
{
    return command.get_subcommands([](const CLI::App*) { return true; });
}

// A known word, and the form in which the user writes it.
struct KnownWord {
    std::string word;
    std::string written;
};

// The options and subcommands of `command`, and the subcommands of these.
std::vector<KnownWord> known_words(const CLI::App& command)
{
    std::vector<KnownWord> known;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back({"--" + name, "--" + name});
    for (const CLI::App* sub : subcommands(command))
        known.push_back({sub->get_name(), sub->get_name()});
    for (const CLI::App* sub : subcommands(command))
        for (const CLI::App* lower : subcommands(*sub))
            known.push_back({lower->get_name(), full_name(*lower)});
    return known;
}

// A suggestion for a word that `command` does not know.
std::string suggestion(const CLI::App& command, const std::string& word)
{
    const std::vector<KnownWord> known = known_words(command);
    std::vector<std::string_view> words(known.size());
    std::ranges::transform(known, words.begin(), &KnownWord::word);
    const auto closest = closest_word(word.substr(0, word.find('=')), words);
    if (!closest)
        return "; see " + full_name(command) + " --help";
    const auto meant = std::ranges::find(known, *closest, &KnownWord::word);
    return "; did you mean " + meant->written + "?";
}

// An option that is given more often than once; nothing if there is none.
std::optional<std::string> repeated_option(const CLI::App& command)
{
    for (const CLI::Option* option : command.get_options())
        if (option->get_expected_max() == 1 && option->results().size() > 1)
            return option->get_name() + ": given " +
                   std::to_string(option->results().size()) + " times; expected once";
    return std::nullopt;
}

// An option without its value, for which the parser's message has the form
// "--part: 1 required FILE missing"; nothing for other messages.
std::optional<std::string> missing_value(const std::string& message)
{
    constexpr std::string_view middle = ": 1 required ";
    constexpr std::string_view end = " missing";
    const std::size_t at = message.find(middle);
    if (at == std::string::npos || !message.ends_with(end))
        return std::nullopt;
    const std::size_t type = at + middle.size();
    const std::string name = message.substr(0, at);
    return name + ": no value; expected " + name + ' ' +
           message.substr(type, message.size() - end.size() - type);
}

}  // namespace

bool names_unknown_command(const CLI::App& program)
{
    const std::vector<std::string> unknown = program.remaining(true);
    return !subcommands(chosen_command(program)).empty() && !unknown.empty() &&
           !unknown.front().starts_with('-');
}

std::optional<std::string> empty_text_message(const CLI::App& program)
{
    const CLI::App& chosen = chosen_command(program);
    for (const CLI::App* command = &chosen; command; command = command->get_parent())
        for (const CLI::Option* option : command->get_options())
            if (std::ranges::find(option->results(), "") != option->results().end())
                return option->get_name() + ": found \"\"; expected a text; see " +
                       full_name(chosen) + " --help";
    return std::nullopt;
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error)
{
    const CLI::App& command = chosen_command(program);
    const std::vector<std::string> unknown = program.remaining(true);
    const bool has_command = command.get_parent() != nullptr;
    const bool is_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) ||
                            dynamic_cast<const CLI::CallForHelp*>(&error) || !has_command;
    if (is_unknown && !unknown.empty())
        return "found \"" + unknown.front() + "\", which " + full_name(command) +
               " does not know" + suggestion(command, unknown.front());
    const std::string message = error.what();
    const auto counted = dynamic_cast<const CLI::ArgumentMismatch*>(&error)
                             ? repeated_option(command)
                             : std::nullopt;
    return counted.value_or(missing_value(message).value_or(message)) + "; see " +
           full_name(command) + " --help";
}

}  // namespace endmill
