// SPDX-License-Identifier: GPL-3.0-or-later
// The program endmill: understands the command line, runs one command, and turns what
// went wrong into a message and an exit code.

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "build_facts.h"
#include "cli/command.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "endmill/io/suggestion.h"

namespace endmill {
namespace {

constexpr const char* footer =
    "Example:\n"
    "  endmill plan datasets/surfaces/net_rot24_7D.json --cutter ball:15\n\n"
    "Exit status: 0 done, yes   1 done, no   2 command line   3 input file   4 geometry\n"
    "             5 output      6 limit      7 our own fault  130, 143 interrupted";

const CLI::App& chosen_command(const CLI::App& program)
{
    const CLI::App* command = &program;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().front();
    return *command;
}

// "endmill eval path-interval": a command with those that it belongs to.
std::string full_name(const CLI::App& command)
{
    const CLI::App* parent = command.get_parent();
    return parent ? full_name(*parent) + " " + command.get_name() : command.get_name();
}

// What was meant by a word that `command` does not know.
std::string suggestion(const CLI::App& command, const std::string& word)
{
    std::vector<std::string> known;
    for (const CLI::Option* option : command.get_options())
        for (const std::string& name : option->get_lnames())
            known.push_back("--" + name);
    for (const CLI::App* sub :
         command.get_subcommands([](const CLI::App*) { return true; }))
        known.push_back(sub->get_name());
    const std::vector<std::string_view> words{known.begin(), known.end()};
    const auto closest = closest_word(word.substr(0, word.find('=')), words);
    return closest
               ? "; did you mean " + std::string{*closest} + "?"
               : "; see endmill " +
                     (command.get_parent() ? command.get_name() + " " : "") + "--help";
}

std::string usage_message(const CLI::App& program, const CLI::ParseError& error)
{
    const CLI::App& command = chosen_command(program);
    const std::vector<std::string> unknown = program.remaining(true);
    const bool has_command = command.get_parent() != nullptr;
    const bool is_unknown = dynamic_cast<const CLI::ExtrasError*>(&error) || !has_command;
    if (is_unknown && !unknown.empty())
        return "found \"" + unknown.front() + "\", which " + full_name(command) +
               " does not know" + suggestion(command, unknown.front());
    return std::string{error.what()} + "; see " + full_name(command) + " --help";
}

ExitCode run(int argc, char** argv, bool json_errors)
{
    CLI::App program{"Computational geometry of sculptured-surface machining.",
                     "endmill"};
    program.footer(footer);
    program.set_version_flag("--version", "endmill " + std::string{program_version});
    program.require_subcommand(1);
    Action action;
    add_info_command(program, action);
    add_plan_command(program, action);
    add_eval_command(program, action);
    add_cite_command(program, action);
    try {
        program.parse(argc, argv);
    } catch (const CLI::CallForVersion& version) {
        print(std::string{version.what()} + "\n");
        return ExitCode::Yes;
    } catch (const CLI::CallForHelp&) {
        print(program.help());
        return ExitCode::Yes;
    } catch (const CLI::ParseError& error) {
        report_error("E_PARAM", usage_message(program, error), ExitCode::Usage,
                     json_errors);
        return ExitCode::Usage;
    }
    return action();
}

}  // namespace
}  // namespace endmill

int main(int argc, char** argv)
{
    using namespace endmill;
    handle_interrupts();
    const std::span<char*> words{argv, static_cast<std::size_t>(argc)};
    const bool json_errors = std::ranges::any_of(words, [](const char* word) {
        return std::string_view{word} == "--json-errors";
    });
    try {
        return static_cast<int>(run(argc, argv, json_errors));
    } catch (...) {
        wait_if_interrupted();
        return static_cast<int>(report_current_exception(json_errors));
    }
}
