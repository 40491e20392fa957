// SPDX-License-Identifier: GPL-3.0-or-later
// endmill toollife: tool life and economic speed from recommended cutting speeds.

#include <memory>
#include <optional>

#include "cli/answer.h"
#include "cli/arguments.h"
#include "cli/console.h"
#include "endmill/files/input_csv.h"
#include "endmill/process/tool_life.h"

namespace endmill {
namespace {

struct ToolLifeOptions {
    CommonOptions common;
    std::string file;
    std::optional<double> change_min;
    std::optional<double> tool_cost;
    std::optional<double> machine_cost_per_min;
    std::optional<double> alpha;
};

// The parser of the command line has checked that all required options are present.
Json tool_life_summary(const ToolLifeOptions& options)
{
    const auto data = read_cutting_speeds(options.file, options.common.limits);
    const SpeedLine line =
        options.alpha ? fitted_speed_line(data, *options.alpha) : fitted_speed_line(data);
    const double life = economic_tool_life(
        line.alpha, {options.change_min.value(), options.tool_cost.value(),
                     options.machine_cost_per_min.value()});
    return {{"alpha", line.alpha},
            {"cb", tool_life_constant(line, life)},
            {"t0_min", life},
            {"v1_m_per_min", line.v1_m_per_min}};
}

ExitCode run_tool_life(const ToolLifeOptions& options)
{
    const Json summary = tool_life_summary(options);
    give_answer(options.common, {options.file}, summary);
    return ExitCode::Yes;
}

}  // namespace

void add_toollife_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "toollife",
        "compute tool life and economic cutting speed from recommended speeds");
    const auto options = std::make_shared<ToolLifeOptions>();
    command
        ->add_option("FILE", options->file,
                     "recommended speeds (CSV: phi_over_pi, v_m_per_min)")
        ->required();
    const NumberDomain from_zero = NumberDomain::from_zero();
    add_number(*command, {"--tool-change-min", "MIN", "time to change a tool", from_zero},
               options->change_min)
        ->required();
    add_number(*command,
               {"--tool-cost", "COST", "cost of a tool, or of regrinding it", from_zero},
               options->tool_cost)
        ->required();
    add_number(
        *command,
        {"--machine-cost-per-min", "COST", "cost of machine and operator per minute"},
        options->machine_cost_per_min)
        ->required();
    add_number(*command,
               {"--alpha", "A",
                "exponent of the tool-life law, between 0 and 1 (default: fitted)",
                NumberDomain::between(0, 1)},
               options->alpha);
    add_common_options(*command, options->common);
    command->footer(
        "V (phi/pi T0)^alpha = C_b, V in m/min, T0 in min; costs in one currency.\n"
        "Prints the result. With --output it also writes DIR/summary.json.\n\n"
        "Example:\n  endmill toollife datasets/materials/steel-cutting-speeds.csv "
        "--tool-change-min 40 --tool-cost 20000 --machine-cost-per-min 200");
    command->callback([options, &action] {
        action = [options] {
            return naming(options->file, [&] { return run_tool_life(*options); });
        };
    });
}

}  // namespace endmill
