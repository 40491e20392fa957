// SPDX-License-Identifier: GPL-3.0-or-later
// endmill machine: directions and positions of a configuration of axes.

#include <memory>

#include "cli/answer.h"
#include "cli/machine_argument.h"
#include "cli/machine_options.h"
#include "cli/machine_summary.h"
#include "cli/rotary_limits_option.h"
#include "endmill/core/error.h"
#include "endmill/core/text.h"

namespace endmill {
namespace {

// Options that have no effect without another one.
void refuse_idle(const MachineOptions& options)
{
    const bool has_positions = !options.at.empty() || options.inverse;
    if (options.point && !has_positions)
        throw DomainError{"--point: expected --at or --inverse as well"};
    if (options.length_mm > 0 && !options.point)
        throw DomainError{"--length: expected --point, and --at or --inverse, as well"};
}

ExitCode run_machine(const MachineOptions& options)
{
    refuse_idle(options);
    const double most_mm = options.common.limits.max_extent_mm;
    const bool is_far =
        options.point && options.point->lpNorm<Eigen::Infinity>() > most_mm;
    if (is_far || options.length_mm > most_mm)
        throw DomainError{"--point, --length: found more than " + to_text(most_mm) +
                          " mm; expected no more (--max-extent)"};
    auto [machine, file] = machine_argument(options.machine, options.common.limits);
    const bool is_valid = machine.configuration.is_valid();
    if (!options.limits.empty())
        machine = limited_machine(machine, options.limits);
    const Json summary = machine_summary(machine, options);
    give_answer(options.common, {file}, summary, machine_text(summary, options));
    return is_valid ? ExitCode::Yes : ExitCode::No;
}

}  // namespace

void add_machine_command(CLI::App& program, Action& action)
{
    CLI::App* command = program.add_subcommand(
        "machine",
        "report tool directions and axis positions of a 3-, 4- or 5-axis "
        "machine");
    const auto options = std::make_shared<MachineOptions>();
    add_machine_options(*command, *options);
    command->footer(
        "phi and theta are rotations of the tool against the part. C,A: phi is the "
        "tilt, theta\n"
        "the rotation of C. A,B: phi is the rotation of the axis nearer to the part. a, "
        "b and c\n"
        "are axis positions: the right-hand rotation of the body that the axis "
        "carries.\n\n"
        "Prints the result. With --output it also writes DIR/summary.json.\n\n"
        "Exit 1: the configuration is not valid; the report has the reason.\n\n"
        "Example:\n"
        "  endmill machine W/caxyBz/T --limits a=-120:30 --contains 45,100 --contains "
        "0,170\n"
        "  endmill machine W/cxyBza/T --at c=-40,a=25 --point 50,20,30 --length 200");
    command->callback(
        [options, &action] { action = [options] { return run_machine(*options); }; });
}

}  // namespace endmill
