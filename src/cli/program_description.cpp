// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/program_description.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "build_facts.h"
#include "endmill/job/child_process.h"

namespace endmill {
namespace {

// Commands that a step or a case cannot run: they run others, or have no input and no result.
constexpr std::array<std::string_view, 5> left_out{"run", "sweep", "demo", "eval",
                                                   "cite"};
// Options that a run sets itself, or that do not change its result.
constexpr std::array<std::string_view, 9> of_the_run{
    "--help", "--output",  "--json",        "--quiet",        "--force",
    "--html", "--threads", "--json-errors", "--json-progress"};

OptionValue value_of(const CLI::Option& option)
{
    if (option.get_items_expected_max() == 0)
        return OptionValue::None;
    const std::string type = option.get_type_name();
    constexpr std::array<std::string_view, 4> files{"FILE", "PART2", "SUMMARY",
                                                    "TOOLPATH"};
    if (std::ranges::find(files, type) != files.end())
        return OptionValue::File;
    if (type == "MACHINE" || type == "STOCK" || type.ends_with("|FILE"))
        return OptionValue::FileOrWord;
    return OptionValue::Text;
}

// The words in the name of a value, such as linuxcnc|fanuc|grbl|FILE; none if it also takes
// numbers or other texts.
std::vector<std::string> words_of(const CLI::Option& option, OptionValue value)
{
    const std::string type = option.get_type_name();
    if (type.find('|') == std::string::npos || value == OptionValue::None)
        return {};
    std::vector<std::string> words;
    std::string_view rest = type;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        const std::string_view word = rest.substr(0, end);
        const bool is_placeholder = std::ranges::any_of(
            word, [](char letter) { return 'A' <= letter && letter <= 'Z'; });
        if (!is_placeholder)
            words.emplace_back(word);
        else if (word != "FILE")
            return {};
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return words;
}

ProgramCommand command_of(const CLI::App& command)
{
    ProgramCommand described{command.get_name(), {}, false};
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_positional()) {
            described.has_input = true;
            described.needs_input = option->get_required();
            continue;
        }
        const std::string name = option->get_name();
        if (std::ranges::find(of_the_run, name) == of_the_run.end())
            described.options.push_back(
                {name, value_of(*option), words_of(*option, value_of(*option))});
    }
    return described;
}

}  // namespace

ProgramDescription description_of(const CLI::App& program)
{
    ProgramDescription described{running_program(), std::string{program_version}, {}};
    // A step or a case is no rank of its own.
    if (described.program.filename() == "endmill-mpi")
        described.program.replace_filename("endmill");
    for (const CLI::App* command : program.get_subcommands({}))
        if (std::ranges::find(left_out, command->get_name()) == left_out.end())
            described.commands.push_back(command_of(*command));
    return described;
}

}  // namespace endmill
