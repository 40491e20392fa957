// SPDX-License-Identifier: GPL-3.0-or-later
// endmill eval: the library's closed formulas by name.

#include <array>
#include <map>
#include <memory>
#include <span>

#include "cli/arguments.h"
#include "cli/console.h"
#include "endmill/core/numbers.h"
#include "endmill/io/output_folder.h"
#include "endmill/planning/path_interval.h"
#include "endmill/planning/step_length.h"

namespace endmill {
namespace {

using Numbers = std::map<std::string, double>;

struct Argument {
    const char* name;
    const char* unit;
    const char* help;
    bool is_positive;
};

struct Formula {
    const char* name;
    const char* help;
    const char* example;
    std::vector<Argument> arguments;
    Json (*value)(const Numbers&);
};

constexpr Argument radius{"radius", "MM", "radius of the ball", true};
constexpr Argument curvature{"curvature", "PER_MM", "positive where the part is convex",
                             false};
constexpr Argument scallop{"scallop", "MM", "scallop height, below the ball's diameter",
                           true};

// The lengths of a result that is Unlimited are infinite, and have no angle.
Json half_angle(const Angle& angle, LengthStatus status)
{
    return status == LengthStatus::Unlimited ? Json(nullptr) : Json(angle.radians());
}

Json path_interval_json(const Numbers& numbers)
{
    const PathInterval interval = path_interval(
        BallCutter{numbers.at("radius")}, numbers.at("curvature"), numbers.at("scallop"));
    return {{"chord_mm", finite_or_null(interval.chord)},
            {"projected_mm", finite_or_null(interval.projected)},
            {"arc_mm", finite_or_null(interval.arc)},
            {"half_angle_rad", half_angle(interval.half_angle, interval.status)},
            {"status", length_status_name(interval.status)}};
}

Json step_length_json(const Numbers& numbers)
{
    const StepLength step =
        step_length(numbers.at("curvature"), numbers.at("chord-tolerance"));
    return {{"chord_mm", finite_or_null(step.chord)},
            {"projected_mm", finite_or_null(step.projected)},
            {"half_angle_rad", half_angle(step.half_angle, step.status)},
            {"status", length_status_name(step.status)}};
}

Json scallop_height_json(const Numbers& numbers)
{
    return {
        {"scallop_mm", scallop_height(BallCutter{numbers.at("radius")},
                                      numbers.at("curvature"), numbers.at("interval"))}};
}

Json highest_scallop_json(const Numbers& numbers)
{
    return {
        {"scallop_mm", finite_or_null(highest_scallop(BallCutter{numbers.at("radius")},
                                                      numbers.at("curvature")))}};
}

const std::array formulas{
    Formula{"path-interval",
            "widest interval between passes that keeps a scallop height, eq. (4), (5)",
            "--radius 5 --curvature 0.01 --scallop 0.1",
            {radius, curvature, scallop},
            path_interval_json},
    Formula{"step-length",
            "longest step that keeps a chord tolerance, eq. (1), (2)",
            "--curvature 0.01 --chord-tolerance 0.5",
            {curvature, {"chord-tolerance", "MM", "from the curve to its chord", true}},
            step_length_json},
    Formula{"scallop-height",
            "scallop that passes at an interval leave, the inverse of path-interval",
            "--radius 7.5 --curvature 0.02 --interval 5",
            {radius, curvature, {"interval", "MM", "chord between two contacts", true}},
            scallop_height_json},
    Formula{"highest-scallop",
            "highest scallop that neighbouring passes leave at all",
            "--radius 5 --curvature 0.1",
            {radius, curvature},
            highest_scallop_json},
};

struct EvalOptions {
    CommonOptions common;
    Numbers numbers;
};

std::string text(const Json& value)
{
    std::string lines;
    for (const auto& [key, item] : value.items())
        lines += key + " = " +
                 (item.is_string() ? item.get<std::string>() : item.dump()) + "\n";
    return lines;
}

ExitCode run_formula(const Formula& formula, const EvalOptions& options)
{
    const Json value = formula.value(options.numbers);
    if (!options.common.output.empty()) {
        OutputFolder folder{options.common.output, options.common.force};
        folder.write("summary.json", value.dump(2) + "\n");
        folder.publish();
    }
    print_result(options.common, value, text(value));
    return ExitCode::Yes;
}

ExitCode list_formulas(const CommonOptions& common)
{
    Json summary = Json::array();
    std::string lines;
    for (const Formula& formula : formulas) {
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
        "eval", "any closed formula of the library, by name; alone: what it knows");
    const auto options = std::make_shared<EvalOptions>();
    command->require_subcommand(0, 1);
    add_common_options(*command, options->common);
    command->footer(
        "Prints; writes DIR/summary.json only with --output.\n\n"
        "Example:\n  endmill eval path-interval --radius 5 --curvature 0.01 "
        "--scallop 0.1 --json");
    for (const Formula& formula : formulas)
        add_formula(*command, formula, options, action);
    command->callback([options, &action] {
        if (!action)  // no formula was named
            action = [options] { return list_formulas(options->common); };
    });
}

}  // namespace endmill
