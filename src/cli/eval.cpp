// SPDX-License-Identifier: GPL-3.0-or-later
// endmill eval: the library's closed formulas by name.

#include <memory>
#include <string>

#include "cli/answer.h"
#include "cli/arguments.h"
#include "cli/console.h"
#include "cli/eval_formulas.h"
#include "endmill/core/error.h"

namespace endmill {
namespace {

struct EvalOptions {
    CommonOptions common;
    Numbers numbers;
};

// A message of the library without the name of the function that begins it.
std::string without_function(const std::string& message)
{
    const std::size_t end = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz_");
    const bool has_name = end != std::string::npos && message.substr(end, 2) == ": ";
    return has_name ? message.substr(end + 2) : message;
}

ExitCode run_formula(const Formula& formula, const EvalOptions& options)
{
    try {
        give_answer(options.common, {}, formula.value(options.numbers));
    } catch (const DomainError& error) {
        throw DomainError{without_function(error.what())};
    }
    return ExitCode::Yes;
}

ExitCode list_formulas(const CommonOptions& common)
{
    Json summary = Json::array();
    std::string lines;
    for (const Formula& formula : eval_formulas()) {
        summary.push_back({{"name", formula.name}, {"help", formula.help}});
        lines += std::string{formula.name} + "\n    " + formula.help +
                 "\n    endmill eval " + formula.name + " " + formula.example + "\n";
    }
    print_result(common, {{"formulas", summary}}, lines);
    return ExitCode::Yes;
}

void add_formula(CLI::App& eval, const Formula& formula,
                 const std::shared_ptr<EvalOptions>& options, Action& action)
{
    CLI::App* command = eval.add_subcommand(formula.name, formula.help);
    command->fallthrough();
    for (const Argument& argument : formula.arguments) {
        const std::string name = argument.name;
        const NumberDomain domain =
            argument.is_positive ? NumberDomain::positive() : NumberDomain::any();
        command
            ->add_option_function<std::string>(
                "--" + name,
                [name, domain, options](const std::string& word) {
                    options->numbers[name] = number_argument("--" + name, word, domain);
                },
                argument.help)
            ->type_name(argument.unit)
            ->required();
    }
    command->footer(std::string{"Example:\n  endmill eval "} + formula.name + " " +
                    formula.example);
    command->callback([&formula, options, &action] {
        action = [&formula, options] { return run_formula(formula, *options); };
    });
}

}  // namespace

void add_eval_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "eval", "evaluate a closed formula; without a name, list the formulas");
    const auto options = std::make_shared<EvalOptions>();
    command->require_subcommand(0, 1);
    add_common_options(*command, options->common);
    command->footer(
        "Prints the result. With --output it also writes DIR/summary.json.\n\n"
        "Example:\n  endmill eval path-interval --radius 5 --curvature 0.01 "
        "--scallop 0.1 --json");
    for (const Formula& formula : eval_formulas())
        add_formula(*command, formula, options, action);
    command->callback([options, &action] {
        if (!action)  // no formula was named
            action = [options] { return list_formulas(options->common); };
    });
}

}  // namespace endmill
