// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/setup_idle.h"

#include <array>

#include <fmt/format.h>

#include "endmill/core/error.h"

namespace endmill {
namespace {

// Of the mesh, its visibility, or a search over facets.
constexpr std::array part_only_options{
    "--units",          "--up",         "--chord-tolerance",   "--clamp",
    "--sphere",         "--visibility", "--incidence-deg",     "--tool",
    "--write-bsm-csv",  "--floor-deg",  "--arc-tolerance-deg", "--max-setups",
    "--from-visibility"};

constexpr std::array set_only_options{"--objective", "--gap", "--max-nodes"};

void refuse_setup_options(const SetupCommandOptions& options,
                          std::span<const char* const> names, const std::string& beside,
                          const std::string& expected)
{
    for (const char* name : names)
        if (options.given.contains(name))
            throw DomainError{
                fmt::format("{}: found with {}; expected {}", name, beside, expected)};
}

}  // namespace

void refuse_idle_setup_options(const SetupCommandOptions& options)
{
    if (!options.points.empty())
        refuse_setup_options(options, part_only_options, "--points",
                             "a PART: directions have neither facets nor a mesh");
    if (options.mode != SetupMode::WholeCones)
        refuse_setup_options(
            options, set_only_options,
            "--mode " + std::string{setup_mode_word(options.mode)},
            "--mode set, which alone searches over whole cones to a bound");
    if (options.family)
        refuse_setup_options(options, std::array{"--clamp"}, "--family",
                             "--machine: a family has no linear axes");
}

void refuse_options_idle_on(std::span<const SetupMachine> machines,
                            const SetupCommandOptions& options)
{
    const MachineConfiguration& first = machines.front().machine.configuration;
    if (machines.size() > 1 || !first.is_valid())
        return;
    const std::string machine =
        machines.front().is_family ? "--family" : "--machine " + first.word;
    if (first.axes() != 4)
        refuse_setup_options(options, std::array{"--arc-tolerance-deg"}, machine,
                             "a machine with one rotary axis");
    if (first.axes() != 5)
        refuse_setup_options(options, set_only_options, machine,
                             "a machine with two rotary axes");
}

}  // namespace endmill
